#pragma once

#include <opencv2/core.hpp>

#include "wardslam/core/frame.h"
#include "wardslam/core/label_space.h"

namespace wardslam::viewer {

/// The frame as a person would like to see it (CV_8UC3, BGR, size of the colour image): things in translucent colours
/// of their classes, those that move in red; boxes with class names, and confidences below 1; key points green where
/// static and red where dynamic; and how many there are of each. Equal frames give equal pictures.
[[nodiscard]] cv::Mat drawAnnotated(const core::Frame& frame, const core::LabelSpace& labels);

}  // namespace wardslam::viewer
