#pragma once

#include <memory>
#include <vector>

#include "wardslam/graph/async_mapper.h"
#include "wardslam/graph/mapper.h"

namespace wardslam::pipeline {

/// Hands keyframes to a Mapper and brings its findings back: at once, in the calling thread (repeatable), or from a
/// thread behind, so that tracking never waits.
class MapKeeper {
 public:
  MapKeeper(std::unique_ptr<graph::Mapper> mapper, bool inBackground);

  void insert(const std::shared_ptr<const odometry::Keyframe>& keyframe);
  [[nodiscard]] std::vector<odometry::MapUpdate> takeUpdates();

  /// Ends the work behind; the mapper then holds all keyframes, and takeUpdates() gives the last of its findings.
  const graph::Mapper& finish();

 private:
  std::unique_ptr<graph::Mapper> mapper_;  ///< Null while the thread behind owns it.
  std::unique_ptr<graph::AsyncMapper> async_;
  std::vector<odometry::MapUpdate> updates_;
};

}  // namespace wardslam::pipeline
