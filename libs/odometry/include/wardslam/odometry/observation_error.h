#pragma once

#include <ceres/loss_function.h>
#include <ceres/rotation.h>

#include <Eigen/Geometry>

#include "wardslam/core/camera_model.h"
#include "wardslam/core/keypoint.h"

namespace wardslam::odometry {

/// A camera pose as Ceres sees it: angle-axis rotation (rad) and translation (m) of T_cam_map.
using PoseVector = Eigen::Matrix<double, 6, 1>;

[[nodiscard]] PoseVector toPoseVector(const Eigen::Isometry3d& T_cam_map);
[[nodiscard]] Eigen::Isometry3d toIsometry(const PoseVector& pose);

// 95 % of correct observations have a smaller squared error (chi-square with 2 and 3 degrees of freedom).
inline constexpr double kChiSquareWithoutDepth = 5.991;
inline constexpr double kChiSquareWithDepth = 7.815;

[[nodiscard]] inline double chiSquareOf(const core::Keypoint& keypoint) {
  return keypoint.hasDepth() ? kChiSquareWithDepth : kChiSquareWithoutDepth;
}

/// What a sighting costs: `robust` (may be null: squared) bent for large errors, weighted by how sure it is that the
/// point is static. The caller owns the result.
[[nodiscard]] inline ceres::LossFunction* weightedLoss(ceres::LossFunction* robust, const core::Keypoint& keypoint) {
  if (keypoint.staticProbability >= 1.0F) return robust;
  return new ceres::ScaledLoss(robust, static_cast<double>(keypoint.staticProbability), ceres::TAKE_OWNERSHIP);
}

/// Error of one sighting of a map point in units of its standard deviation: two components of reprojection and, where
/// depth was measured, a third along the optical axis (with the noise of the camera's depth).
struct ObservationError {
  ObservationError(const core::Keypoint& keypoint, const core::CameraModel& camera_, double pixelSigma_px,
                   double depthSigmaScale)
      : camera(camera_),
        measured_px(keypoint.undistorted_px.x, keypoint.undistorted_px.y),
        measuredDepth_m(static_cast<double>(keypoint.depth_m)),
        sigma_px(pixelSigma_px * static_cast<double>(keypoint.scale)),
        sigmaDepth_m(depthSigmaScale * core::depthSigma_m(keypoint, camera.depthNoise)) {}

  template <class T>
  bool operator()(const T* pose, const T* p_map, T* error) const {
    Eigen::Matrix<T, 3, 1> p_cam;
    ceres::AngleAxisRotatePoint(pose, p_map, p_cam.data());
    p_cam += Eigen::Map<const Eigen::Matrix<T, 3, 1>>(pose + 3);
    if (p_cam.z() < T(0.01)) return false;
    error[0] = (p_cam.x() / p_cam.z() * camera.fx_px + camera.cx_px - measured_px.x()) / sigma_px;
    error[1] = (p_cam.y() / p_cam.z() * camera.fy_px + camera.cy_px - measured_px.y()) / sigma_px;
    if (measuredDepth_m > 0.0) error[2] = (p_cam.z() - measuredDepth_m) / sigmaDepth_m;
    return true;
  }

  /// Squared norm; infinite for a point behind the camera.
  [[nodiscard]] double squared(const PoseVector& pose, const Eigen::Vector3d& p_map_m) const;

  const core::CameraModel& camera;
  Eigen::Vector2d measured_px;
  double measuredDepth_m;
  double sigma_px;
  double sigmaDepth_m;
};

}  // namespace wardslam::odometry
