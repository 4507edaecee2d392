#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace wardslam::viewer {

/// Moves labels of a picture apart: each, in order, to the free place nearest to where it is wanted, within the
/// picture; where all about it is taken, it stays where it is wanted.
[[nodiscard]] std::vector<cv::Rect> movedApart(const std::vector<cv::Rect>& wanted, const cv::Size& picture);

}  // namespace wardslam::viewer
