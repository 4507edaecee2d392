#pragma once

#include <opencv2/core.hpp>

#include "wardslam/core/frame.h"

/// Pictures that leave a run show no people, unless somebody asked for them.
namespace wardslam::core {

/// Where people are, and what else moves (who is not recognised gives himself away by it), with a margin around, for
/// masks end short of hair and fingers. CV_8UC1 of the size of the labels, 255 there, else 0. `labelBits`: bit i =
/// PixelLabel i.
[[nodiscard]] cv::Mat peoplePixels(const cv::Mat& labelBits);

/// The same of a frame; all of it where nobody looked for people.
[[nodiscard]] cv::Mat peoplePixels(const Frame& frame);

/// A copy of the image with a flat grey where `people` is not 0; of another size than the image, it is stretched.
[[nodiscard]] cv::Mat blanked(const cv::Mat& image, const cv::Mat& people);

}  // namespace wardslam::core
