#pragma once

#include <opencv2/core.hpp>

namespace wardslam::evaluation {

/// Outlines compared: the boundary measure F of the DAVIS benchmark (Perazzi et al., CVPR 2016), with a disc of
/// `tolerance_px` in place of a search for the best assignment, as there. 1 = every point of either outline lies
/// within the tolerance of the other. The image border is no outline.
struct BoundaryAgreement {
  double precision = 0.0;  ///< Share of the detected outline near the true one.
  double recall = 0.0;     ///< Share of the true outline near the detected one.
  double f = 0.0;          ///< Harmonic mean; 0 where both are 0, 1 where neither mask has an outline.
};

/// Both CV_8UC1 of one size, anything but 0 = in the mask.
[[nodiscard]] BoundaryAgreement compareBoundaries(const cv::Mat& detected, const cv::Mat& truth, int tolerance_px);

/// About what DAVIS allows, 0.75 % of the diagonal: 6 px at 640×480.
[[nodiscard]] int davisTolerance_px(const cv::Size& image);

}  // namespace wardslam::evaluation
