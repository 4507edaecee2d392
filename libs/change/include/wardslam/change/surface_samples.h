#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "wardslam/core/frame.h"

namespace wardslam::change {

/// Points (m, camera frame) of what the frame's depth image shows within `box_px` (raw) where `isIn(row, column)`: a
/// regular grid of at most about `most` pixels of the box, those with depth.
[[nodiscard]] std::vector<Eigen::Vector3d> sampleSurface(const core::Frame& frame, const cv::Rect& box_px, int most,
                                                         const std::function<bool(int, int)>& isIn);

/// Smallest distance (m) between two sets of points; infinite where one is empty.
[[nodiscard]] double gapBetween(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b);

}  // namespace wardslam::change
