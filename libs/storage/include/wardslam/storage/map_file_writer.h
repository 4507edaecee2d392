#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "wardslam/graph/mapper.h"
#include "wardslam/mapping/map_builder.h"
#include "wardslam/odometry/map_update.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::storage {

/// Keeps a map file abreast of a run: what changed goes into it, in one transaction, keyframe by keyframe, each
/// with the piece it belongs to. For one thread at a time.
///
/// A write that fails (the disk is full, another program holds the file) is tried again with the next keyframe, as the
/// run is worth more than its map; it is counted, and told when it begins.
class MapFileWriter {
 public:
  /// Receives one sentence about survived trouble, in the thread that writes.
  using WarningSink = std::function<void(const std::string&)>;

  /// Makes an empty map; where a file is there already, it stays until the first keyframe. Throws core::InputError when
  /// no map can be made there.
  MapFileWriter(const std::filesystem::path& file, const MapHeader& header);

  /// Goes on with the map of an earlier run, opened for writing. With the first write its floor plan is gone, for it is
  /// not that of the growing map, and zones and class names are those of this run.
  explicit MapFileWriter(MapFile file);

  void setWarningSink(WarningSink warn) { warn_ = std::move(warn); }

  /// Before the first keyframe: stamps in the file are seconds since then (UNIX s), not UNIX seconds. For new maps.
  void setStampOrigin(double origin_s) { stampOrigin_s_ = origin_s; }

  /// Writes that failed so far and were, or are to be, made up for.
  [[nodiscard]] std::size_t failedWrites() const { return failedWrites_; }

  /// A new keyframe, and what the graph found out about earlier ones; in the order in which the builder hears of them.
  void add(const std::shared_ptr<const odometry::Keyframe>& keyframe);
  void apply(const odometry::MapUpdate& update);

  /// Writes what is new.
  void write(mapping::MapBuilder& builder);

  /// Writes the map as it is in the end, floor plan and loops included; where another program holds the file, beside
  /// it, and the name goes over. Of what was erased meanwhile, key points that did not last among it, nothing is left
  /// in the file. Throws core::InputError when that fails; may be tried again then.
  void finish(mapping::MapBuilder& builder, const graph::Mapper& mapper);

 private:
  [[nodiscard]] MapChanges takeFrom(mapping::MapBuilder& builder);
  void put(const MapChanges& changes, int patience_ms);
  void compact();
  void forgetWritten(const MapChanges& changes);
  void fail(const core::InputError& error);

  /// A map that is to take the place of another.
  struct Successor {
    std::filesystem::path file;
    MapHeader header;
  };

  std::optional<MapFile> file_;         ///< Nothing while `successor_` waits for its first keyframe.
  std::optional<Successor> successor_;  ///< Nothing once it is in place.
  bool goesOn_ = false;                 ///< In a map that was there.
  bool hasBegun_ = false;               ///< What holds for the whole run is in the file.
  std::set<odometry::KeyframeId> changedTiles_;
  std::set<odometry::KeyframeId> written_;
  mapping::MapParts unwritten_;  ///< Of the builder.
  MapChanges pending_;           ///< Of the graph.

  std::optional<double> stampOrigin_s_;
  WarningSink warn_ = [](const std::string&) {};
  std::size_t failedWrites_ = 0;
  bool isFailing_ = false;  ///< The last write did.
};

}  // namespace wardslam::storage
