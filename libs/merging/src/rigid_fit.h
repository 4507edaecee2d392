#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "wardslam/graph/graph_options.h"

namespace wardslam::merging {

/// One camera, seen in the frames of two maps.
struct PosePair {
  Eigen::Isometry3d T_a_cam;
  Eigen::Isometry3d T_b_cam;
};

/// The transform that brings the second poses onto the first, with what is known of it (Alignment).
struct RigidFit {
  Eigen::Isometry3d T_a_b = Eigen::Isometry3d::Identity();
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  double misfit_m = 0.0;
  double misfit_rad = 0.0;
};

/// Least squares over positions and directions, with a robust loss (Gauss-Newton, weights of Cauchy's). `noise` is of
/// one pose; where the pairs fit worse, as maps that bend do, so much larger is the covariance. At least one pair.
[[nodiscard]] RigidFit fitRigidly(const std::vector<PosePair>& pairs, const graph::PoseGraphOptions& noise);

}  // namespace wardslam::merging
