#pragma once

#include <Eigen/Geometry>

/// Rotations as the axis times the angle (rad).
namespace wardslam::core {

[[nodiscard]] inline Eigen::Vector3d rotationVectorOf(const Eigen::Matrix3d& R) {
  const Eigen::AngleAxisd rotation(R);
  return rotation.axis() * rotation.angle();
}

[[nodiscard]] inline Eigen::Matrix3d rotationBy(const Eigen::Vector3d& rotation_rad) {
  const double angle_rad = rotation_rad.norm();
  if (!(angle_rad > 0.0)) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle_rad, rotation_rad / angle_rad).toRotationMatrix();
}

/// The motion of a translation and a rotation vector.
[[nodiscard]] inline Eigen::Isometry3d motionBy(const Eigen::Vector3d& translation_m,
                                                const Eigen::Vector3d& rotation_rad) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = rotationBy(rotation_rad);
  T.translation() = translation_m;
  return T;
}

/// The matrix that takes w to v x w.
[[nodiscard]] inline Eigen::Matrix3d crossProductWith(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

}  // namespace wardslam::core
