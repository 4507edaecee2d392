#pragma once

#include <Eigen/Geometry>

namespace wardslam::odometry {

/// How fast a camera moves, in its own frame.
struct Twist {
  Eigen::Vector3d translation_mps = Eigen::Vector3d::Zero();
  Eigen::Vector3d rotation_radps = Eigen::Vector3d::Zero();  ///< Axis times speed.
};

/// Images farther apart do not tell how fast a camera is within one.
inline constexpr double kLongestStep_s = 0.2;

/// That leads along `T_before_now` within so many seconds (not 0).
[[nodiscard]] inline Twist twistOf(const Eigen::Isometry3d& T_before_now, double seconds) {
  const Eigen::AngleAxisd rotation(T_before_now.linear());
  return {T_before_now.translation() / seconds, rotation.axis() * rotation.angle() / seconds};
}

/// T_before_now after so many seconds (of a small motion: turning and going do not mix).
[[nodiscard]] inline Eigen::Isometry3d after(const Twist& twist, double seconds) {
  Eigen::Isometry3d T_before_now = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d rotation_rad = seconds * twist.rotation_radps;
  const double angle_rad = rotation_rad.norm();
  if (angle_rad > 0.0)
    T_before_now.linear() = Eigen::AngleAxisd(angle_rad, rotation_rad / angle_rad).toRotationMatrix();
  T_before_now.translation() = seconds * twist.translation_mps;
  return T_before_now;
}

}  // namespace wardslam::odometry
