#pragma once

#include <Eigen/Geometry>

namespace wardslam::odometry {

using PoseCovariance = Eigen::Matrix<double, 6, 6>;

/// How something moved since the image before, by what is no camera: wheels, say.
struct MotionPrior {
  Eigen::Isometry3d T_previous_now = Eigen::Isometry3d::Identity();
  /// Positive definite, of a translation (m) and a rotation vector (rad) in the frame it has now: it truly is at
  /// T_previous_now * (that motion).
  PoseCovariance covariance = PoseCovariance::Identity();
};

/// Where the camera ought to be in an image.
struct PosePrior {
  Eigen::Isometry3d T_cam_map = Eigen::Isometry3d::Identity();
  PoseCovariance covariance = PoseCovariance::Identity();  ///< As that of MotionPrior, in that camera's frame.
};

/// Standard deviation (m) of the axis whose translation is least sure.
[[nodiscard]] double worstSigma_m(const PoseCovariance& covariance);

/// What the way from one pose to another adds to that, where the errors of the way add to those of the first.
[[nodiscard]] double addedSigma_m(const PoseCovariance& before, const PoseCovariance& now);

/// What a covariance of frame a (as in MotionPrior) is in frame b, both fixed to one body.
[[nodiscard]] PoseCovariance transformed(const PoseCovariance& ofA, const Eigen::Isometry3d& T_a_b);

/// The same motion of another frame fixed to the same body: of the camera, from that of the robot's base.
[[nodiscard]] MotionPrior transformed(const MotionPrior& ofA, const Eigen::Isometry3d& T_a_b);

/// One motion after another, whose errors have nothing to do with each other.
[[nodiscard]] MotionPrior composed(const MotionPrior& first, const MotionPrior& second);

/// Whether it can be used: all numbers finite, and the covariance positive definite.
[[nodiscard]] bool isUsable(const MotionPrior& prior);

}  // namespace wardslam::odometry
