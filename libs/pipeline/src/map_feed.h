#pragma once

#include <memory>
#include <vector>

#include "view_selection.h"
#include "wardslam/core/frame.h"
#include "wardslam/core/profiler.h"
#include "wardslam/core/stage.h"
#include "wardslam/mapping/map_builder.h"
#include "wardslam/odometry/odometry.h"
#include "wardslam/storage/map_file_writer.h"

namespace wardslam::pipeline {

/// Says what is done with a map builder, and in which order: keyframes before the views that hang on them, what the
/// keyframe graph found out before what was seen after it, and the map file written after every keyframe.
class MapFeed {
 public:
  /// Time is measured as "mapping.add" and "storage.write". The stage must outlive this object; the profiler, the
  /// stage.
  MapFeed(core::Stage<mapping::MapBuilder>& stage, const ViewSelection& selection, core::Profiler& profiler)
      : stage_(stage), selection_(selection), profiler_(profiler) {}

  /// Before the first frame: has every keyframe written when it is worked in. The writer must outlive the stage.
  void writeTo(storage::MapFileWriter& writer) { writer_ = &writer; }

  /// A frame, where it was taken, and what the keyframe graph found out since the frame before.
  void update(const core::Frame& frame, const odometry::OdometryResult& odometry,
              const std::vector<odometry::MapUpdate>& updates);

  /// What the keyframe graph found out after the last frame.
  void apply(const odometry::MapUpdate& update);

 private:
  void add(const std::shared_ptr<const odometry::Keyframe>& keyframe);
  void add(mapping::View view);
  void write();

  core::Stage<mapping::MapBuilder>& stage_;
  ViewSelection selection_;
  core::Profiler& profiler_;
  storage::MapFileWriter* writer_ = nullptr;
};

}  // namespace wardslam::pipeline
