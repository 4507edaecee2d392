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

bool DepthAnchor::isNear(const Eigen::Isometry3d& T_map_cam) const {
  if (!image_) return false;
  const Eigen::Isometry3d way = image_->T_map_cam.inverse() * T_map_cam;
  return way.translation().norm() < options_.anchor_distance_m &&
         Eigen::AngleAxisd(way.linear()).angle() < options_.anchor_angle_rad;
}

void DepthAnchor::remember(const DepthImage& depth, const core::CameraModel& camera, const Eigen::Isometry3d& T_map_cam,
                           const PoseCovariance& covariance) {
  if (depth.depth_m.empty() || isNear(T_map_cam)) return;
  image_ = Image{DepthSurface(depth, camera), T_map_cam, covariance};
}

void DepthAnchor::move(const Eigen::Isometry3d& correction) {
  if (image_) image_->T_map_cam = core::rigid(correction * image_->T_map_cam);
}

bool DepthAnchor::wouldHold(const DepthImage& depth, const core::CameraModel& camera) const {
  if (depth.depth_m.empty()) return false;
  const DepthSurface surface(depth, camera);
  const DepthAlignment onItself = alignDepth(surface, surface, Eigen::Isometry3d::Identity());
  return onItself.open == 0 && onItself.overlap >= options_.min_overlap;
}

std::optional<HeldPose> DepthAnchor::hold(const DepthImage& depth, const core::CameraModel& camera,
                                          const PosePrior& predicted, const Eigen::Isometry3d& T_cam_map_start) const {
  if (!image_ || depth.depth_m.empty()) return std::nullopt;
  const Eigen::Isometry3d T_anchor_map = image_->T_map_cam.inverse();
  const DepthAlignment alignment =
      alignDepth(DepthSurface(depth, camera), image_->surface, T_anchor_map * T_cam_map_start.inverse());
  if (alignment.overlap < options_.min_overlap || alignment.agreement < options_.min_agreement) return std::nullopt;
  const MotionPrior fused = combined(alignment, {T_anchor_map * predicted.T_cam_map.inverse(), predicted.covariance});
  const MotionPrior inMap = composed({Eigen::Isometry3d::Identity(), image_->covariance}, fused);
  if (!(worstSigma_m(inMap.covariance) <= options_.max_sigma_m)) return std::nullopt;
  const Eigen::Isometry3d T_cam_map = core::rigid(inMap.T_previous_now.inverse() * T_anchor_map);
  return HeldPose{{T_cam_map, inMap.covariance}, alignment.open == 0};
}

}  // namespace wardslam::odometry
