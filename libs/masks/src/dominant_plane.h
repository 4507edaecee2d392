#pragma once

#include <opencv2/core.hpp>

namespace wardslam::masks {

/// 255 on all pixels of the plane that most of the measured pixels `among` (CV_8UC1) lie on – the floor around a
/// person, for example –, 0 elsewhere and where no plane has a fair share of them. Repeatable.
[[nodiscard]] cv::Mat dominantPlane(const cv::Mat& inverseDepth, const cv::Mat& among);

}  // namespace wardslam::masks
