#pragma once

#include <opencv2/core.hpp>

#include "wardslam/core/segmentation.h"
#include "wardslam/filters/dynamic_test.h"
#include "wardslam/knowledge/motion_rules.h"

namespace wardslam::filters {

/// A segmented picture as core::PixelLabel bits, for core::annotate(). CV_8UC1.
///  - Person: a class that moves by itself. Movable: one that can be moved. Thing: any class but those that move.
///  - Dynamic: where `movingMask` (CV_8UC1) is not 0, and the whole of a movable instance of which at least half is
///    dynamic by `test`, whose image must be set.
[[nodiscard]] cv::Mat motionLabels(const core::Segmentation& segmentation, const cv::Mat& movingMask,
                                   const knowledge::MotionRules& rules, DynamicTest& test);

}  // namespace wardslam::filters
