#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace wardslam::features {

/// Keeps `count` key points spread over the image: square cells take turns in giving their strongest one (by
/// response) until there are enough. Ties are broken by position, so the choice never depends on the input's order.
/// `cellSize_px` > 0. Fewer than `count` come back when there are fewer. The result is ordered by turn and strength.
[[nodiscard]] std::vector<cv::KeyPoint> spreadEvenly(std::vector<cv::KeyPoint> keypoints, std::size_t count,
                                                     int cellSize_px);

}  // namespace wardslam::features
