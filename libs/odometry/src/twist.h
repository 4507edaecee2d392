#pragma once

#include <Eigen/Geometry>

#include "wardslam/core/rotation_vector.h"

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
  return {T_before_now.translation() / seconds, core::rotationVectorOf(T_before_now.linear()) / seconds};
}

/// T_before_now after so many seconds (of a small motion: turning and going do not mix).
[[nodiscard]] inline Eigen::Isometry3d after(const Twist& twist, double seconds) {
  return core::motionBy(seconds * twist.translation_mps, seconds * twist.rotation_radps);
}

}  // namespace wardslam::odometry
