#pragma once

#include <Eigen/Geometry>

namespace wardslam::core {

/// The floor under a camera as a plane in the camera frame: normal_cam · p + height_m = 0 for its points p (m).
struct GroundPlane {
  Eigen::Vector3d normal_cam = -Eigen::Vector3d::UnitY();  ///< Unit length, up.
  double height_m = 0.0;                                   ///< Of the camera over the plane.
  /// Of the normal's shift along each of the two tangents() (rad), and of the height (m).
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

  /// Of a point in the camera frame over the plane, m.
  [[nodiscard]] double heightOf_m(const Eigen::Vector3d& p_cam_m) const { return normal_cam.dot(p_cam_m) + height_m; }

  /// The standard deviation of heightOf_m(), for what is not known of the plane.
  [[nodiscard]] double sigmaOf_m(const Eigen::Vector3d& p_cam_m) const;

  /// Two unit vectors in the plane, at right angles; the same for the same normal.
  [[nodiscard]] Eigen::Matrix<double, 3, 2> tangents() const;

  /// The camera over its ground: z up, z = 0 on the plane under the camera, which is at x = y = 0.
  [[nodiscard]] Eigen::Isometry3d T_ground_cam() const;

  /// The plane z = 0 of a frame in which the camera stands at `T_level_cam`.
  [[nodiscard]] static GroundPlane atZero(const Eigen::Isometry3d& T_level_cam);

  /// The same plane seen from a camera that this one stands at `T_other_cam` from.
  [[nodiscard]] GroundPlane seenFrom(const Eigen::Isometry3d& T_other_cam) const;
};

}  // namespace wardslam::core
