#include "view_selection.h"

#include "wardslam/mapping/view_spacing.h"

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
  return mapping::isFarEnough(options_, *last_, {frame.stamp_s, odometry.T_map_cam});
}

}  // namespace wardslam::pipeline
