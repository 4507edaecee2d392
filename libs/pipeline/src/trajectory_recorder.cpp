#include "wardslam/pipeline/trajectory_recorder.h"

namespace wardslam::pipeline {

void TrajectoryRecorder::onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) {
  if (odometry.hasPose()) poses_.push_back({frame.stamp_s, odometry.referenceKeyframe, odometry.T_keyframe_cam});
}

core::Trajectory TrajectoryRecorder::corrected(
    const std::map<odometry::KeyframeId, Eigen::Isometry3d>& T_map_keyframe) const {
  core::Trajectory trajectory;
  trajectory.reserve(poses_.size());
  for (const RelativePose& pose : poses_) {
    trajectory.push_back({pose.stamp_s, T_map_keyframe.at(pose.keyframe) * pose.T_keyframe_cam});
  }
  return trajectory;
}

}  // namespace wardslam::pipeline
