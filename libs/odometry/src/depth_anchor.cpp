#include "depth_anchor.h"

#include "twist.h"
#include "wardslam/core/rigid_transform.h"

namespace wardslam::odometry {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// What two measurements of one motion say together, each by its covariance.
MotionPrior combined(const DepthAlignment& aligned, const MotionPrior& predicted) {
  const Eigen::Isometry3d T_aligned_predicted = aligned.T_before_now.inverse() * predicted.T_previous_now;
  const Twist inOneSecond = twistOf(T_aligned_predicted, 1.0);
  Vector6 toPredicted;
  toPredicted << inOneSecond.translation_mps, inOneSecond.rotation_radps;
  const PoseCovariance ofPrediction = predicted.covariance.inverse();
  const PoseCovariance covariance = (aligned.information + ofPrediction).inverse();
  const Vector6 way = covariance * ofPrediction * toPredicted;
  return {core::rigid(aligned.T_before_now * after({way.head<3>(), way.tail<3>()}, 1.0)), covariance};
}

}  // namespace

void DepthAnchor::see(const DepthImage& depth, const core::CameraModel& camera) {
  depth_ = depth;
  surface_.reset();
  if (depth.depth_m.empty()) return;
  if (!squares_ || !(squares_->camera == camera)) squares_ = std::make_shared<SquareRays>(camera, depth.depth_m.size());
}

/// Only what is used is worked out.
const std::shared_ptr<const DepthSurface>& DepthAnchor::surface() {
  if (!surface_) surface_ = std::make_shared<DepthSurface>(depth_, squares_);
  return surface_;
}

bool DepthAnchor::isNear(const Eigen::Isometry3d& T_map_cam) const {
  if (!anchor_) return false;
  const Eigen::Isometry3d way = anchor_->T_map_cam.inverse() * T_map_cam;
  return way.translation().norm() < options_.anchor_distance_m &&
         Eigen::AngleAxisd(way.linear()).angle() < options_.anchor_angle_rad;
}

void DepthAnchor::remember(const Eigen::Isometry3d& T_map_cam, const PoseCovariance& covariance) {
  if (depth_.depth_m.empty() || isNear(T_map_cam)) return;
  anchor_ = Anchor{surface(), T_map_cam, covariance};
}

void DepthAnchor::move(const Eigen::Isometry3d& correction) {
  if (anchor_) anchor_->T_map_cam = core::rigid(correction * anchor_->T_map_cam);
}

bool DepthAnchor::wouldHold() {
  if (depth_.depth_m.empty()) return false;
  const DepthAlignment onItself =
      alignDepth(*surface(), *surface(), Eigen::Isometry3d::Identity(), AlignmentStart::IsNear);
  return onItself.open == 0 && onItself.overlap >= options_.min_overlap &&
         worstSigma_m(onItself.information.inverse()) <= options_.max_sigma_m;
}

std::optional<HeldPose> DepthAnchor::hold(const PosePrior& predicted, const Eigen::Isometry3d& T_cam_map_start,
                                          AlignmentStart start) {
  if (!anchor_ || depth_.depth_m.empty()) return std::nullopt;
  const Eigen::Isometry3d T_anchor_map = anchor_->T_map_cam.inverse();
  const DepthAlignment alignment =
      alignDepth(*surface(), *anchor_->surface, T_anchor_map * T_cam_map_start.inverse(), start);
  if (alignment.overlap < options_.min_overlap || alignment.agreement < options_.min_agreement) return std::nullopt;
  const MotionPrior fused = combined(alignment, {T_anchor_map * predicted.T_cam_map.inverse(), predicted.covariance});
  const MotionPrior inMap = composed({Eigen::Isometry3d::Identity(), anchor_->covariance}, fused);
  if (!(worstSigma_m(inMap.covariance) <= options_.max_sigma_m)) return std::nullopt;
  const Eigen::Isometry3d T_cam_map = core::rigid(inMap.T_previous_now.inverse() * T_anchor_map);
  return HeldPose{{T_cam_map, inMap.covariance}, alignment.open == 0};
}

}  // namespace wardslam::odometry
