#pragma once

#include <map>
#include <vector>

#include "wardslam/core/trajectory.h"
#include "wardslam/odometry/map_update.h"
#include "wardslam/pipeline/frame_observer.h"

namespace wardslam::pipeline {

/// Remembers every tracked frame relative to its keyframe, so that later corrections of the map correct it too. This is
/// the one thing in a run that grows with time: by about 150 bytes a frame.
class TrajectoryRecorder : public FrameObserver {
 public:
  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override;

  /// Frames of keyframes that were removed hang on the heirs from now on.
  void onUpdate(const odometry::MapUpdate& update) override;

  /// One pose per frame tracked by one of these keyframes, by where they are now.
  [[nodiscard]] core::Trajectory corrected(
      const std::map<odometry::KeyframeId, Eigen::Isometry3d>& T_map_keyframe) const;

 private:
  struct RelativePose {
    double stamp_s = 0.0;
    Eigen::Isometry3d T_keyframe_cam = Eigen::Isometry3d::Identity();
  };

  std::map<odometry::KeyframeId, std::vector<RelativePose>> framesOf_;
};

}  // namespace wardslam::pipeline
