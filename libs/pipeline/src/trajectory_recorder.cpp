#include "wardslam/pipeline/trajectory_recorder.h"

#include <algorithm>

namespace wardslam::pipeline {

void TrajectoryRecorder::onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) {
  if (odometry.state == odometry::State::Initialising) return;
  RelativePose pose{frame.stamp_s, odometry.T_keyframe_cam, {}, odometry.hasPose(), odometry.keyframe != nullptr};
  if (odometry.covariance) pose.covariance = odometry.covariance->cast<float>();
  framesOf_[odometry.referenceKeyframe].push_back(pose);
}

void TrajectoryRecorder::onUpdate(const odometry::MapUpdate& update) {
  for (const auto& removed : update.removedKeyframes) {
    const auto frames = framesOf_.extract(removed.id);
    if (frames.empty()) continue;
    auto& heirs = framesOf_[removed.heir];
    for (RelativePose pose : frames.mapped()) {
      pose.T_keyframe_cam = removed.T_heir_cam * pose.T_keyframe_cam;
      pose.isKeyframe = false;
      heirs.push_back(pose);
    }
  }
}

/// In order of time.
std::vector<odometry::EstimatedPose> TrajectoryRecorder::placed(
    const std::map<odometry::KeyframeId, Eigen::Isometry3d>& T_map_keyframe) const {
  std::vector<odometry::EstimatedPose> poses;
  for (const auto& [keyframe, frames] : framesOf_) {
    const auto placed = T_map_keyframe.find(keyframe);
    if (placed == T_map_keyframe.end()) continue;  // of another piece
    for (const RelativePose& pose : frames) {
      poses.push_back({pose.stamp_s, placed->second * pose.T_keyframe_cam, {}, pose.isSeen});
      if (pose.covariance && !pose.isKeyframe) poses.back().covariance = pose.covariance->cast<double>();
    }
  }
  std::stable_sort(poses.begin(), poses.end(), [](const auto& a, const auto& b) { return a.stamp_s < b.stamp_s; });
  return poses;
}

core::Trajectory TrajectoryRecorder::corrected(
    const std::map<odometry::KeyframeId, Eigen::Isometry3d>& T_map_keyframe) const {
  core::Trajectory trajectory;
  for (const auto& pose : placed(T_map_keyframe)) {
    if (pose.isSeen) trajectory.push_back({pose.stamp_s, pose.T_map_cam});
  }
  return trajectory;
}

core::Trajectory TrajectoryRecorder::onOneWay(
    const std::map<odometry::KeyframeId, Eigen::Isometry3d>& T_map_keyframe) const {
  return odometry::smoothed(placed(T_map_keyframe), options_);
}

}  // namespace wardslam::pipeline
