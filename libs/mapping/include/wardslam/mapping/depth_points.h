#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

#include "wardslam/core/camera_model.h"

namespace wardslam::mapping {

/// A pixel with depth, and the point it measures in the camera frame.
struct DepthPoint {
  cv::Point raw_px;
  Eigen::Vector3d p_cam_m = Eigen::Vector3d::Zero();
};

/// Of every so many pixels of a depth image (CV_32FC1, m, raw pixels; 0 = none) those with depth, row by row.
[[nodiscard]] std::vector<DepthPoint> depthPoints(const cv::Mat& depth_m, const core::CameraModel& camera, int step_px);

}  // namespace wardslam::mapping
