#pragma once

#include <opencv2/core.hpp>

namespace wardslam::segmentation {

/// From which probability a pixel shows a person. Where nothing was measured the network guesses: there, more is asked.
struct PersonThresholds {
  double measured = 0.3;
  double unmeasured = 0.8;
};

/// What each pixel of a network's input shows.
struct PixelClasses {
  cv::Mat indices;      ///< CV_8UC1: the class of the network,
  cv::Mat probability;  ///< CV_32FC1: and how probable it is.
};

/// Turns scores (CV_32F [1, classes, height, width], before the softmax) into the class of each pixel of the picture
/// the network saw: probabilities are resampled linearly. Class `person` wherever it reaches its threshold, elsewhere
/// the best of the others; -1: the best of all. `depth_m`: CV_32FC1 of the size of the picture, 0 = none. At most 256
/// classes; scores that are no numbers give class 0 with probability 0.
[[nodiscard]] PixelClasses decodeDepthScores(const cv::Mat& scores, const cv::Mat& depth_m, int person,
                                             const PersonThresholds& thresholds);

}  // namespace wardslam::segmentation
