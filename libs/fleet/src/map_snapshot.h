#pragma once

#include <filesystem>

#include "file_chunks.h"
#include "sighting_intervals.h"
#include "wardslam/building/rooms.h"
#include "wardslam/mapping/semantic_map.h"

namespace wardslam::fleet {

/// A map file as it is at one moment, in a file of its own until this ends: its bytes and what they say. Throws
/// core::InputError where it is no sound map.
class MapSnapshot {
 public:
  explicit MapSnapshot(const std::filesystem::path& file);
  ~MapSnapshot();
  MapSnapshot(const MapSnapshot&) = delete;
  MapSnapshot& operator=(const MapSnapshot&) = delete;

  [[nodiscard]] const std::filesystem::path& copy() const { return copy_; }
  [[nodiscard]] const FileDigests& digests() const { return digests_; }
  [[nodiscard]] const mapping::SemanticMap& map() const { return map_; }
  [[nodiscard]] const building::Rooms& rooms() const { return rooms_; }
  [[nodiscard]] Traces tracesOf(mapping::ObjectId object) const;
  [[nodiscard]] double firstStamp_s() const { return first_s_; }  ///< Of its keyframes; 0 where it has none.
  [[nodiscard]] double lastStamp_s() const { return last_s_; }

 private:
  void read(const std::filesystem::path& original);

  std::filesystem::path folder_;
  std::filesystem::path copy_;
  FileDigests digests_;
  mapping::SemanticMap map_;
  building::Rooms rooms_;
  std::map<mapping::ObjectId, Traces> traces_;
  double first_s_ = 0.0;
  double last_s_ = 0.0;
};

}  // namespace wardslam::fleet
