#pragma once

#include <mrpt/poses/CPose3DPDFGaussian.h>

#include "wardslam/odometry/motion_prior.h"

/// Covariances of poses in two tongues: MRPT's, of x y z (m) yaw pitch roll (rad), and ours (odometry::MotionPrior), of
/// a translation (m) and a rotation vector (rad) of the body as it stands.
namespace wardslam::mrpt_slam {

/// To first order. Pitch must not be ±90°, where yaw and roll are one.
[[nodiscard]] odometry::PoseCovariance bodyCovariance(const mrpt::poses::CPose3DPDFGaussian& pdf);

[[nodiscard]] mrpt::poses::CPose3DPDFGaussian toGaussian(const Eigen::Isometry3d& T_map_body,
                                                         const odometry::PoseCovariance& covariance);

}  // namespace wardslam::mrpt_slam
