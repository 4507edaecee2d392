#pragma once

#include <opencv2/core.hpp>

#include "wardslam/core/frame.h"
#include "wardslam/core/label_space.h"

namespace wardslam::viewer {

/// The frame as a person would like to see it (CV_8UC3, BGR, size of the colour image): masks in translucent colours,
/// boxes with class names, key points green where static and red where dynamic, and how many there are of each.
[[nodiscard]] cv::Mat drawAnnotated(const core::Frame& frame, const core::LabelSpace& labels);

}  // namespace wardslam::viewer
