#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

namespace wardslam::evaluation {

/// How well decisions of one kind (is this pixel dynamic?) agree with the truth, counted. Scores add up over images.
struct DetectionScore {
  std::uint64_t truePositives = 0;
  std::uint64_t falsePositives = 0;
  std::uint64_t falseNegatives = 0;
  std::uint64_t trueNegatives = 0;

  void add(bool detected, bool isTrue);
  DetectionScore& operator+=(const DetectionScore& other);

  [[nodiscard]] double precision() const;  ///< Share of what was detected that is true; NaN where nothing was.
  [[nodiscard]] double recall() const;     ///< Share of what is true that was detected; NaN where nothing is.
  [[nodiscard]] double spared() const;     ///< Share of what is not true that was not detected; NaN where all is true.
  [[nodiscard]] double iou() const;        ///< Intersection over union (Jaccard index); NaN where there is neither.
};

/// Per pixel: both CV_8UC1 of one size, anything but 0 = yes.
[[nodiscard]] DetectionScore comparePixels(const cv::Mat& detected, const cv::Mat& truth);

}  // namespace wardslam::evaluation
