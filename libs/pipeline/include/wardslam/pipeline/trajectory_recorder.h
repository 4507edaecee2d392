#pragma once

#include <map>
#include <vector>

#include "wardslam/core/trajectory.h"
#include "wardslam/pipeline/frame_observer.h"

namespace wardslam::pipeline {

/// Remembers every tracked frame relative to its keyframe, so that later corrections of the map correct it too.
class TrajectoryRecorder : public FrameObserver {
 public:
  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override;

  /// One pose per tracked frame, by where the keyframes are now.
  [[nodiscard]] core::Trajectory corrected(
      const std::map<odometry::KeyframeId, Eigen::Isometry3d>& T_map_keyframe) const;

 private:
  struct RelativePose {
    double stamp_s = 0.0;
    odometry::KeyframeId keyframe = 0;
    Eigen::Isometry3d T_keyframe_cam = Eigen::Isometry3d::Identity();
  };

  std::vector<RelativePose> poses_;
};

}  // namespace wardslam::pipeline
