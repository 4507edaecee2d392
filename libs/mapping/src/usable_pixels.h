#pragma once

#include <opencv2/core.hpp>

#include "wardslam/knowledge/motion_rules.h"
#include "wardslam/mapping/mapping_options.h"
#include "wardslam/mapping/view.h"

namespace wardslam::mapping {

/// Steps in depth below this (m) at depth z (m) are no edges: three times the noise and a step of the Kinect's
/// disparity (z² / 348 m), and 2 cm of slope.
[[nodiscard]] float edgeStep_m(float z_m, const core::DepthNoise& noise = {});

/// Pixels that may enter the map (CV_8UC1, 255 or 0): within range, off everything that moves and a margin round it,
/// and no fliers, which hang in the air between a near and a far surface where a depth pixel saw both.
[[nodiscard]] cv::Mat usablePixels(const View& view, const knowledge::ClassSet& moving, const CloudOptions& options);

/// Of each pixel the least depth in its neighbourhood, 0 where any is unknown: points are seen through only when all so
/// near to them is farther away.
[[nodiscard]] cv::Mat nearestAround(const cv::Mat& depth_m);

}  // namespace wardslam::mapping
