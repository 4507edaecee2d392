#pragma once

#include <opencv2/core.hpp>

#include "wardslam/core/segmentation.h"
#include "wardslam/knowledge/motion_rules.h"

namespace wardslam::filters {

/// A segmented picture as core::PixelLabel bits, for core::annotate(). CV_8UC1.
///  - Person: a class that moves by itself. Movable: one that can be moved. Thing: any class but those that move.
///  - Dynamic: where `dynamicMask` (CV_8UC1) is 255; elsewhere it must be 0.
[[nodiscard]] cv::Mat motionLabels(const core::Segmentation& segmentation, const cv::Mat& dynamicMask,
                                   const knowledge::MotionRules& rules);

}  // namespace wardslam::filters
