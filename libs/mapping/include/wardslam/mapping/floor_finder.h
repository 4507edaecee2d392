#pragma once

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "wardslam/core/camera_model.h"

namespace wardslam::mapping {

/// Finds the floor in one depth image (CV_32FC1, m, raw pixels; 0 = none) and returns the camera's pose over it: z up,
/// z = 0 on the floor, otherwise as the guess says. The guess must know "up" to 35 degrees; the floor is the largest
/// level plane with next to nothing beneath it. Nothing when no such plane is in sight.
[[nodiscard]] std::optional<Eigen::Isometry3d> levelWithFloor(const cv::Mat& depth_m, const core::CameraModel& camera,
                                                              const Eigen::Isometry3d& T_level_cam_guess);

}  // namespace wardslam::mapping
