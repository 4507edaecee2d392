#include "boundary_agreement.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace wardslam::evaluation {
namespace {

/// Pixels of the mask with a neighbour outside it; 255 there.
cv::Mat outlineOf(const cv::Mat& mask) {
  const cv::Mat binary = mask != 0;
  cv::Mat inner;
  cv::erode(binary, inner, cv::getStructuringElement(cv::MORPH_CROSS, {3, 3}));
  return binary - inner;
}

cv::Mat widened(const cv::Mat& outline, int tolerance_px) {
  cv::Mat result;
  const int side = 2 * tolerance_px + 1;
  cv::Mat disc(side, side, CV_8UC1);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int dx = x - tolerance_px;
      const int dy = y - tolerance_px;
      disc.at<std::uint8_t>(y, x) = dx * dx + dy * dy <= tolerance_px * tolerance_px ? 1 : 0;
    }
  }
  cv::dilate(outline, result, disc);
  return result;
}

/// An outline that does not exist has no part that is wrong, unless the other does exist.
double shareNear(const cv::Mat& outline, const cv::Mat& other, int tolerance_px) {
  const int length = cv::countNonZero(outline);
  if (length == 0) return cv::countNonZero(other) == 0 ? 1.0 : 0.0;
  return static_cast<double>(cv::countNonZero(outline & widened(other, tolerance_px))) / length;
}

}  // namespace

BoundaryAgreement compareBoundaries(const cv::Mat& detected, const cv::Mat& truth, int tolerance_px) {
  CV_Assert(detected.type() == CV_8UC1 && truth.type() == CV_8UC1 && detected.size() == truth.size());
  const cv::Mat trueOutline = outlineOf(truth);
  const cv::Mat detectedOutline = outlineOf(detected);
  BoundaryAgreement boundary;
  boundary.precision = shareNear(detectedOutline, trueOutline, tolerance_px);
  boundary.recall = shareNear(trueOutline, detectedOutline, tolerance_px);
  const double sum = boundary.precision + boundary.recall;
  boundary.f = sum > 0 ? 2 * boundary.precision * boundary.recall / sum : 0.0;
  return boundary;
}

int davisTolerance_px(const cv::Size& image) {
  return static_cast<int>(std::lround(0.0075 * std::hypot(image.width, image.height)));
}

}  // namespace wardslam::evaluation
