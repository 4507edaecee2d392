#pragma once

#include <Eigen/Geometry>

namespace wardslam::core {

/// The rigid transform nearest to `T`, whose rotation may have lost its scale by rounding.
///
/// Eigen inverts an isometry by transposing its rotation: of one that is too large by a part in 10¹⁶ the inverse is so
/// too, and where products of such are put into the next product the error grows without bound.
[[nodiscard]] inline Eigen::Isometry3d rigid(const Eigen::Isometry3d& T) {
  Eigen::Isometry3d nearest = T;
  nearest.linear() = Eigen::Affine3d(T.matrix()).rotation();  // by polar decomposition
  return nearest;
}

/// Whether a matrix that somebody wrote down is a rotation, but for the digits left out.
[[nodiscard]] inline bool isRotation(const Eigen::Matrix3d& R, double tolerance) {
  return R.determinant() > 0.0 && (R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < tolerance;
}

}  // namespace wardslam::core
