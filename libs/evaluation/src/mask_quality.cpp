#include "wardslam/evaluation/mask_quality.h"

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace wardslam::evaluation {
namespace {

double ratio(std::size_t part, std::size_t whole) {
  if (whole == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(part) / static_cast<double>(whole);
}

std::size_t count(const cv::Mat& mask) { return static_cast<std::size_t>(cv::countNonZero(mask)); }

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
  const std::size_t length = count(outline);
  if (length == 0) return count(other) == 0 ? 1.0 : 0.0;
  return ratio(count(outline & widened(other, tolerance_px)), length);
}

}  // namespace

double PixelAgreement::precision() const { return ratio(right, right + wrong); }
double PixelAgreement::recall() const { return ratio(right, right + missed); }
double PixelAgreement::iou() const { return ratio(right, right + wrong + missed); }

PixelAgreement& PixelAgreement::operator+=(const PixelAgreement& other) {
  right += other.right;
  wrong += other.wrong;
  missed += other.missed;
  return *this;
}

PixelAgreement comparePixels(const cv::Mat& truth, const cv::Mat& estimate) {
  CV_Assert(truth.type() == CV_8UC1 && estimate.type() == CV_8UC1 && truth.size() == estimate.size());
  PixelAgreement pixels;
  pixels.right = count((truth != 0) & (estimate != 0));
  pixels.wrong = count(estimate) - pixels.right;
  pixels.missed = count(truth) - pixels.right;
  return pixels;
}

BoundaryAgreement compareBoundaries(const cv::Mat& truth, const cv::Mat& estimate, int tolerance_px) {
  CV_Assert(truth.type() == CV_8UC1 && estimate.type() == CV_8UC1 && truth.size() == estimate.size());
  const cv::Mat trueOutline = outlineOf(truth);
  const cv::Mat estimatedOutline = outlineOf(estimate);
  BoundaryAgreement boundary;
  boundary.precision = shareNear(estimatedOutline, trueOutline, tolerance_px);
  boundary.recall = shareNear(trueOutline, estimatedOutline, tolerance_px);
  const double sum = boundary.precision + boundary.recall;
  boundary.f = sum > 0 ? 2 * boundary.precision * boundary.recall / sum : 0.0;
  return boundary;
}

int davisTolerance_px(const cv::Size& image) {
  return static_cast<int>(std::lround(0.0075 * std::hypot(image.width, image.height)));
}

}  // namespace wardslam::evaluation
