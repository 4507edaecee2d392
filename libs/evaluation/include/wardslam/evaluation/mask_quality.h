#pragma once

#include <cstddef>
#include <opencv2/core.hpp>

namespace wardslam::evaluation {

// Masks are CV_8UC1 images of equal size, anything but 0 belongs to the mask. Ratios with nothing below are NaN.

/// Pixels of an estimated mask compared with the true one. May be added up over images.
struct PixelAgreement {
  std::size_t right = 0;   ///< In both.
  std::size_t wrong = 0;   ///< In the estimate alone: background taken for the thing.
  std::size_t missed = 0;  ///< In the truth alone.

  [[nodiscard]] double precision() const;
  [[nodiscard]] double recall() const;
  [[nodiscard]] double iou() const;  ///< Intersection over union, the Jaccard index.
  PixelAgreement& operator+=(const PixelAgreement& other);
};

[[nodiscard]] PixelAgreement comparePixels(const cv::Mat& truth, const cv::Mat& estimate);

/// Outlines compared: the boundary measure F of the DAVIS benchmark (Perazzi et al., CVPR 2016), with a disc of
/// `tolerance_px` in place of a search for the best assignment, as there. 1 = every point of either outline lies
/// within the tolerance of the other. The image border is no outline.
struct BoundaryAgreement {
  double precision = 0.0;  ///< Share of the estimated outline near the true one.
  double recall = 0.0;     ///< Share of the true outline near the estimated one.
  double f = 0.0;          ///< Harmonic mean; 0 where both are 0, 1 where neither mask has an outline.
};

[[nodiscard]] BoundaryAgreement compareBoundaries(const cv::Mat& truth, const cv::Mat& estimate, int tolerance_px);

/// About what DAVIS allows, 0.75 % of the diagonal: 6 px at 640×480.
[[nodiscard]] int davisTolerance_px(const cv::Size& image);

}  // namespace wardslam::evaluation
