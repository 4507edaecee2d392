#pragma once

#include <memory>
#include <vector>

#include "view_selection.h"
#include "wardslam/core/frame.h"
#include "wardslam/core/profiler.h"
#include "wardslam/core/stage.h"
#include "wardslam/mapping/map_builder.h"
#include "wardslam/odometry/odometry.h"
#include "wardslam/pipeline/shared_updates.h"
#include "wardslam/pipeline/when_behind.h"
#include "wardslam/storage/map_file_writer.h"

namespace wardslam::pipeline {

/// Says what is done with a map builder, and in which order: keyframes before the views that hang on them, what the
/// keyframe graph found out before what was seen after it, and the map file written after every keyframe. When too much
/// waits, the caller does; only views that are no keyframes may be left out instead.
class MapFeed {
 public:
  /// Time is measured as "mapping.add" and "storage.write". The stage must outlive this object; the profiler, the
  /// stage.
  MapFeed(core::Stage<mapping::MapBuilder>& stage, const ViewSelection& selection, core::Profiler& profiler,
          WhenBehind whenBehind)
      : stage_(stage), selection_(selection), profiler_(profiler), whenBehind_(whenBehind) {}

  /// Before the first frame: has every keyframe written when it is worked in. The writer must outlive the stage.
  void writeTo(storage::MapFileWriter& writer) { writer_ = &writer; }

  /// A frame, where it was taken, and what the keyframe graph found out since the frame before.
  void update(const core::Frame& frame, const odometry::OdometryResult& odometry, const SharedUpdates& updates);

  /// Views that were left out because nobody knew yet who is in them.
  [[nodiscard]] std::size_t viewsWithoutMasks() const { return selection_.withoutMasks(); }

  /// What the keyframe graph found out after the last frame.
  void apply(const std::shared_ptr<const odometry::MapUpdate>& update);

 private:
  void add(const std::shared_ptr<const odometry::Keyframe>& keyframe);
  void add(mapping::View view);
  void write();

  core::Stage<mapping::MapBuilder>& stage_;
  ViewSelection selection_;
  core::Profiler& profiler_;
  WhenBehind whenBehind_;
  storage::MapFileWriter* writer_ = nullptr;
};

}  // namespace wardslam::pipeline
