#pragma once

#include <opencv2/core.hpp>

namespace wardslam::masks {

/// How much the colours speak for the background: log(P(colour | background) / P(colour | thing)), CV_32FC1, mean of
/// 5×5 pixels. The colours of both are learnt from the pixels of two masks (CV_8UC1); a colour that neither has says
/// nothing (0).
[[nodiscard]] cv::Mat backgroundEvidence(const cv::Mat& color_bgr, const cv::Mat& thing, const cv::Mat& background);

}  // namespace wardslam::masks
