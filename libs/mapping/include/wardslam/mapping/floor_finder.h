#pragma once

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "wardslam/core/camera_model.h"
#include "wardslam/core/ground_plane.h"

namespace wardslam::mapping {

/// What is known of the ground before an image is looked at.
struct GroundExpectation {
  static constexpr double kMaxTilt_rad = 35.0 * M_PI / 180.0;

  Eigen::Vector3d up_cam = -Eigen::Vector3d::UnitY();  ///< By gravity, how the camera is mounted, or earlier images.
  double maxTilt_rad = kMaxTilt_rad;                   ///< How far the plane's normal may be off.
  std::optional<double> height_m;                      ///< Of the camera over it;
  double heightTolerance_m = 0.0;                      ///< by how much that may be off.
};

/// The ground in one depth image (CV_32FC1, m, raw pixels; 0 = none): the largest plane that is as level as expected
/// and, where a height is expected, as far beneath the camera; else one with next to nothing beneath it. Its
/// covariance is by the camera's depth noise and by how uneven the plane is. Nothing when no such plane is in sight.
[[nodiscard]] std::optional<core::GroundPlane> findGround(const cv::Mat& depth_m, const core::CameraModel& camera,
                                                          const GroundExpectation& expected);

/// Finds the floor in one depth image and returns the camera's pose over it: z up, z = 0 on the floor, otherwise as the
/// guess says. The guess must know "up" to 35 degrees. Nothing when no floor is in sight.
[[nodiscard]] std::optional<Eigen::Isometry3d> levelWithFloor(const cv::Mat& depth_m, const core::CameraModel& camera,
                                                              const Eigen::Isometry3d& T_level_cam_guess);

}  // namespace wardslam::mapping
