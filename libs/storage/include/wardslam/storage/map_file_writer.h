#pragma once

#include <filesystem>
#include <memory>
#include <set>

#include "wardslam/graph/mapper.h"
#include "wardslam/mapping/map_builder.h"
#include "wardslam/odometry/map_update.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::storage {

/// Keeps a map file abreast of a run: what changed goes into it, in one transaction, keyframe by keyframe, each
/// with the piece it belongs to. For one thread at a time.
class MapFileWriter {
 public:
  /// Makes an empty map in place of a file that may be there. Throws core::InputError when that cannot be.
  MapFileWriter(const std::filesystem::path& file, const MapHeader& header);

  /// Goes on with the map of an earlier run, opened for writing.
  explicit MapFileWriter(MapFile file);

  /// A new keyframe, and what the graph found out about earlier ones; in the order in which the builder hears of them.
  void add(const std::shared_ptr<const odometry::Keyframe>& keyframe);
  void apply(const odometry::MapUpdate& update);

  /// Writes what is new. A write that fails (the disk is full, say) is tried again with the next, as the run is worth
  /// more than its map.
  void write(mapping::MapBuilder& builder);

  /// Writes the map as it is in the end, floor plan and loops included. Throws core::InputError when that fails.
  void finish(mapping::MapBuilder& builder, const graph::Mapper& mapper);

 private:
  [[nodiscard]] MapChanges takeFrom(mapping::MapBuilder& builder);
  void commit(const MapChanges& changes);

  MapFile file_;
  std::set<odometry::KeyframeId> written_;
  mapping::MapParts unwritten_;  ///< Of the builder.
  MapChanges pending_;           ///< Of the graph.
};

}  // namespace wardslam::storage
