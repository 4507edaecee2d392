#pragma once

#include <opencv2/core.hpp>

#include "wardslam/core/segmentation.h"

namespace wardslam::segmentation {

struct DepthLabelling {
  double focalLength_px = 0.0;  ///< Of both images.
  int minArea_px = 1;           ///< What is smaller is no instance.
  core::ClassId person = 0;     ///< People are compact: a small step in depth tells two apart. 0: no such class.
};

/// Tells things of one class apart by depth. `classIds`: CV_8UC1, 0 = none; `depth_m`: CV_32FC1 of the same size, 0 =
/// none. Instance ids (CV_16UC1) from 1, by the first pixel of each:
///
///  1. Pixels side by side belong together where they have one class and no step in depth between them.
///  2. So do parts of one class across a gap of less than half a metre, where both edges have one depth and what lies
///     between is nearer (an arm before a bed) or not measured and of that class (a shadow).
///  3. What was not measured, and scraps, go to what they touch.
///
[[nodiscard]] cv::Mat labelByDepth(const cv::Mat& classIds, const cv::Mat& depth_m, const DepthLabelling& options);

}  // namespace wardslam::segmentation
