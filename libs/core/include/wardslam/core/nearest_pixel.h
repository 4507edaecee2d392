#pragma once

#include <algorithm>
#include <opencv2/core.hpp>

namespace wardslam::core {

/// The pixel of an image of this size that a place (raw pixels) lies in; of a place beside the image, the nearest.
[[nodiscard]] inline cv::Point nearestPixel(const cv::Point2f& raw_px, const cv::Size& size) {
  return {std::clamp(cvRound(raw_px.x), 0, size.width - 1), std::clamp(cvRound(raw_px.y), 0, size.height - 1)};
}

}  // namespace wardslam::core
