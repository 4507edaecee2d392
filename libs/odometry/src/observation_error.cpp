#include "wardslam/odometry/observation_error.h"

#include <limits>

namespace wardslam::odometry {

PoseVector toPoseVector(const Eigen::Isometry3d& T_cam_map) {
  const Eigen::AngleAxisd rotation(T_cam_map.linear());
  PoseVector pose;
  pose << rotation.angle() * rotation.axis(), T_cam_map.translation();
  return pose;
}

Eigen::Isometry3d toIsometry(const PoseVector& pose) {
  Eigen::Isometry3d T_cam_map = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d rotation = pose.head<3>();
  if (rotation.norm() > 0) {
    T_cam_map.linear() = Eigen::AngleAxisd(rotation.norm(), rotation.normalized()).toRotationMatrix();
  }
  T_cam_map.translation() = pose.tail<3>();
  return T_cam_map;
}

double ObservationError::squared(const PoseVector& pose, const Eigen::Vector3d& p_map_m) const {
  Eigen::Vector3d error = Eigen::Vector3d::Zero();
  if (!(*this)(pose.data(), p_map_m.data(), error.data())) return std::numeric_limits<double>::infinity();
  return error.squaredNorm();
}

}  // namespace wardslam::odometry
