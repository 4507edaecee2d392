#pragma once

#include <opencv2/core.hpp>

#include "wardslam/core/depth_noise.h"

namespace wardslam::masks {

/// 255 on all pixels of the plane that most of the measured pixels `among` (CV_8UC1) lie on – the floor around a
/// person, for example –, 0 elsewhere and where no plane has a fair share of them. On it is what is off by no more than
/// 1 cm and twice the noise. Repeatable.
[[nodiscard]] cv::Mat dominantPlane(const cv::Mat& inverseDepth, const cv::Mat& among, const core::DepthNoise& noise);

}  // namespace wardslam::masks
