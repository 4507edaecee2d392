#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <string>

#include "wardslam/core/trajectory.h"
#include "wardslam/mapping/floor_plan.h"

namespace wardslam::mrpt_slam {

/// The floor plan from above, y up (white: free, black: occupied, grey: unknown), with the way of the camera (red) and
/// where the robot stands and looks (blue); without a plan, the way alone, over what lies around it. CV_8UC3.
[[nodiscard]] cv::Mat drawEstimation(const mapping::FloorPlan& plan, const core::Trajectory& trajectory,
                                     const Eigen::Isometry3d& T_map_base);

/// As PNG or BMP, by the ending of the name; with another, `.png` is added. Throws core::InputError when it cannot be
/// written.
void writePicture(const cv::Mat& picture, const std::string& file);

}  // namespace wardslam::mrpt_slam
