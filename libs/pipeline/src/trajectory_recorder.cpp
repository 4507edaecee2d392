#include "wardslam/pipeline/trajectory_recorder.h"

#include <algorithm>

namespace wardslam::pipeline {

void TrajectoryRecorder::onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) {
  if (odometry.hasPose()) framesOf_[odometry.referenceKeyframe].push_back({frame.stamp_s, odometry.T_keyframe_cam});
}

void TrajectoryRecorder::onUpdate(const odometry::MapUpdate& update) {
  for (const auto& removed : update.removedKeyframes) {
    const auto frames = framesOf_.extract(removed.id);
    if (frames.empty()) continue;
    auto& heirs = framesOf_[removed.heir];
    for (const RelativePose& pose : frames.mapped()) {
      heirs.push_back({pose.stamp_s, removed.T_heir_cam * pose.T_keyframe_cam});
    }
  }
}

core::Trajectory TrajectoryRecorder::corrected(
    const std::map<odometry::KeyframeId, Eigen::Isometry3d>& T_map_keyframe) const {
  core::Trajectory trajectory;
  for (const auto& [keyframe, frames] : framesOf_) {
    const auto placed = T_map_keyframe.find(keyframe);
    if (placed == T_map_keyframe.end()) continue;  // of another piece
    const Eigen::Isometry3d& T_map = placed->second;
    for (const RelativePose& pose : frames) trajectory.push_back({pose.stamp_s, T_map * pose.T_keyframe_cam});
  }
  std::sort(trajectory.begin(), trajectory.end(), [](const auto& a, const auto& b) { return a.stamp_s < b.stamp_s; });
  return trajectory;
}

}  // namespace wardslam::pipeline
