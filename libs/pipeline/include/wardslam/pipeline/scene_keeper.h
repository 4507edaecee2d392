#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "wardslam/core/frame.h"
#include "wardslam/core/profiler.h"
#include "wardslam/core/trajectory.h"
#include "wardslam/mapping/async_map_builder.h"
#include "wardslam/mapping/map_builder.h"
#include "wardslam/odometry/odometry.h"
#include "wardslam/storage/map_file_writer.h"

namespace wardslam::pipeline {

/// Feeds a MapBuilder: chooses the frames that show something new and brings it what the keyframe graph finds out. The
/// builder works at once, in the calling thread (repeatable), or in a thread behind, so that tracking never waits.
class SceneKeeper {
 public:
  struct Options {
    mapping::ViewOptions views;
    bool inBackground = true;
    bool needsSegmentation = false;  ///< Frames without masks are left out: somebody may be in them.
  };

  /// Time is measured as "mapping.add". The profiler must outlive this object.
  SceneKeeper(std::unique_ptr<mapping::MapBuilder> builder, const Options& options, core::Profiler& profiler);

  /// Before the first frame: has every keyframe written when it is worked in, in the thread the builder works in, as
  /// "storage.write". The writer must outlive this object.
  void writeTo(storage::MapFileWriter& writer) { writer_ = &writer; }

  /// A frame, where it was taken, and what the keyframe graph found out since the frame before.
  void update(const core::Frame& frame, const odometry::OdometryResult& odometry,
              const std::vector<odometry::MapUpdate>& updates);

  /// What the keyframe graph found out after the last frame.
  void apply(const odometry::MapUpdate& update);

  /// Views that came faster than they could be worked in and were left out.
  [[nodiscard]] std::size_t dropped() const { return async_ ? async_->dropped() : dropped_; }

  /// Ends the work behind; the builder then holds all that was added.
  mapping::MapBuilder& finish();

 private:
  [[nodiscard]] bool showsSomethingNew(const core::Frame& frame, const odometry::OdometryResult& odometry) const;
  void add(const std::shared_ptr<const odometry::Keyframe>& keyframe);
  void addView(const core::Frame& frame, const odometry::OdometryResult& odometry);
  void post(std::function<void(mapping::MapBuilder&)> work);

  Options options_;
  core::Profiler& profiler_;
  storage::MapFileWriter* writer_ = nullptr;
  std::unique_ptr<mapping::MapBuilder> builder_;  ///< Null while the thread behind owns it.
  std::unique_ptr<mapping::AsyncMapBuilder> async_;
  std::size_t dropped_ = 0;
  std::optional<core::StampedPose> lastView_;
};

}  // namespace wardslam::pipeline
