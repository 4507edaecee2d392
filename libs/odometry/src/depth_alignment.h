#pragma once

#include <Eigen/Geometry>

#include "depth_surface.h"
#include "wardslam/odometry/motion_prior.h"

namespace wardslam::odometry {

/// Where the camera is relative to an earlier image, by the surfaces that both show.
struct DepthAlignment {
  Eigen::Isometry3d T_before_now = Eigen::Isometry3d::Identity();
  /// Inverse of a covariance as MotionPrior has it, in the frame of the camera now. Nothing (zero) in the directions
  /// that the surfaces leave open: along a bare corridor, say. There T_before_now is as it was guessed.
  PoseCovariance information = PoseCovariance::Zero();
  int open = 6;            ///< Directions left open, of six.
  double overlap = 0.0;    ///< Share of the points of the image now that lie on a surface of the one before, ...
  double agreement = 0.0;  ///< ... and of those only whose place that image shows.
};

/// How far off a guess may be.
enum class AlignmentStart {
  MayBeFar,  ///< A prediction: decimetres.
  IsNear,    ///< A pose that points tell: centimetres.
};

/// Point-to-plane alignment of `now` to `before`, by projection; each pair weighs by the noise of both depths across
/// the surface. Directions to which surfaces are turned no more than noise could turn them are found from the normal
/// equations and left as guessed (Zhang, Kaess, Singh: "On degeneracy of optimization-based state estimation problems",
/// ICRA 2016).
[[nodiscard]] DepthAlignment alignDepth(const DepthSurface& now, const DepthSurface& before,
                                        const Eigen::Isometry3d& T_before_now_guess,
                                        AlignmentStart start = AlignmentStart::MayBeFar);

}  // namespace wardslam::odometry
