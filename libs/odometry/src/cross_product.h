#pragma once

#include <Eigen/Core>

namespace wardslam::odometry {

/// The matrix that takes w to v x w.
[[nodiscard]] inline Eigen::Matrix3d crossProductWith(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

}  // namespace wardslam::odometry
