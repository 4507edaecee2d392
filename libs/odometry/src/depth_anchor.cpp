#include "depth_anchor.h"

#include "wardslam/core/rigid_transform.h"

namespace wardslam::odometry {

bool DepthAnchor::isNear(const Eigen::Isometry3d& T_map_cam) const {
  if (!image_) return false;
  const Eigen::Isometry3d way = image_->T_map_cam.inverse() * T_map_cam;
  return way.translation().norm() < options_.anchor_distance_m &&
         Eigen::AngleAxisd(way.linear()).angle() < options_.anchor_angle_rad;
}

void DepthAnchor::remember(const DepthImage& depth, const core::CameraModel& camera,
                           const Eigen::Isometry3d& T_map_cam) {
  if (depth.depth_m.empty() || isNear(T_map_cam)) return;
  image_ = Image{DepthSurface(depth, camera), T_map_cam};
}

void DepthAnchor::move(const Eigen::Isometry3d& correction) {
  if (image_) image_->T_map_cam = core::rigid(correction * image_->T_map_cam);
}

std::optional<HeldPose> DepthAnchor::hold(const DepthImage& depth, const core::CameraModel& camera,
                                          const PosePrior& predicted) const {
  if (!image_ || depth.depth_m.empty()) return std::nullopt;
  const Eigen::Isometry3d T_anchor_map = image_->T_map_cam.inverse();
  const DepthAlignment alignment =
      alignDepth(DepthSurface(depth, camera), image_->surface, T_anchor_map * predicted.T_cam_map.inverse());
  if (alignment.overlap < options_.min_overlap || alignment.agreement < options_.min_agreement) return std::nullopt;
  const PoseCovariance covariance = (alignment.information + predicted.covariance.inverse()).inverse();
  if (!(worstSigma_m(covariance) <= options_.max_sigma_m)) return std::nullopt;
  return HeldPose{{core::rigid(alignment.T_before_now.inverse() * T_anchor_map), covariance}, alignment.open == 0};
}

}  // namespace wardslam::odometry
