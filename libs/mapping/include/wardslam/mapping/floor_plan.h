#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

namespace wardslam::mapping {

/// What a robot can drive on: an occupancy grid over the map frame's x-y plane.
struct FloorPlan {
  static constexpr unsigned char kFree = 0;
  static constexpr unsigned char kOccupied = 100;
  static constexpr unsigned char kUnknown = 255;

  cv::Mat cells;                                       ///< CV_8UC1, one of the above; row grows with y, column with x.
  double resolution_m = 0.05;                          ///< Side of a cell.
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();  ///< Map coordinates of the outer corner of cell (0, 0).
};

}  // namespace wardslam::mapping
