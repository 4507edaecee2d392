#include "view_selection.h"

#include <Eigen/Geometry>

namespace wardslam::pipeline {
namespace {

mapping::View viewOf(const core::Frame& frame, const odometry::OdometryResult& odometry) {
  mapping::View view;
  view.keyframe = odometry.referenceKeyframe;
  view.isKeyframe = odometry.keyframe != nullptr;
  view.T_keyframe_cam = odometry.T_keyframe_cam;
  view.stamp_s = frame.stamp_s;
  view.camera = frame.camera;
  view.color_bgr = frame.color_bgr;
  view.depth_m = frame.depth_m;
  view.segmentation = frame.segmentation;
  view.mayMove = frame.mayMove;
  return view;
}

}  // namespace

std::optional<mapping::View> ViewSelection::select(const core::Frame& frame, const odometry::OdometryResult& odometry) {
  if (!showsSomethingNew(frame, odometry)) return std::nullopt;
  if (needsSegmentation_ && frame.segmentation.empty()) {
    ++withoutMasks_;
    return std::nullopt;
  }
  last_ = {frame.stamp_s, odometry.T_map_cam};
  return viewOf(frame, odometry);
}

bool ViewSelection::showsSomethingNew(const core::Frame& frame, const odometry::OdometryResult& odometry) const {
  if (!odometry.hasPose()) return false;
  if (odometry.keyframe || !last_) return true;
  const Eigen::Isometry3d step = last_->T_map_cam.inverse() * odometry.T_map_cam;
  return step.translation().norm() >= options_.step_m ||
         Eigen::AngleAxisd(step.linear()).angle() >= options_.turn_rad ||
         frame.stamp_s - last_->stamp_s >= options_.gap_s;
}

}  // namespace wardslam::pipeline
