#include "orb_corners.h"

#include <array>
#include <cmath>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

namespace wardslam::features {
namespace {

constexpr int kRadius_px = kOrbPatch_px / 2;
constexpr int kBorder_px = kRadius_px + 1;

/// How far the circle reaches to either side, by rows from its middle.
std::array<int, kRadius_px + 1> halfWidths() {
  std::array<int, kRadius_px + 1> widths{};
  for (int row = 0; row <= kRadius_px; ++row) {
    const double radius_px = kRadius_px + 0.5;
    widths[static_cast<std::size_t>(row)] = static_cast<int>(std::sqrt(radius_px * radius_px - row * row));
  }
  return widths;
}

}  // namespace

std::vector<cv::Mat> orbPyramid(const cv::Mat& gray, double scaleFactor, int levels) {
  std::vector<cv::Mat> pyramid;
  for (int level = 0; level < levels; ++level) {
    const double scale = std::pow(scaleFactor, level);
    const cv::Size size(cvRound(gray.cols / scale), cvRound(gray.rows / scale));
    if (std::min(size.width, size.height) <= 2 * kBorder_px) break;
    cv::Mat copy = gray;
    if (level > 0) cv::resize(pyramid.back(), copy, size, 0, 0, cv::INTER_LINEAR_EXACT);
    pyramid.push_back(copy);
  }
  return pyramid;
}

std::vector<cv::KeyPoint> strongestCorners(const cv::Mat& level, int fastThreshold, std::size_t most) {
  std::vector<cv::KeyPoint> corners;
  cv::FAST(level, corners, fastThreshold, /*nonmaxSuppression=*/true);
  cv::KeyPointsFilter::runByImageBorder(corners, level.size(), kBorder_px);
  cv::KeyPointsFilter::retainBest(corners, static_cast<int>(most));
  return corners;
}

float centroidAngle_deg(const cv::Mat& level, const cv::Point& centre) {
  static const auto kHalfWidths = halfWidths();
  int m10 = 0;
  int m01 = 0;
  for (int y = -kRadius_px; y <= kRadius_px; ++y) {
    const auto* middle = level.ptr<std::uint8_t>(centre.y + y) + centre.x;
    const int halfWidth = kHalfWidths[static_cast<std::size_t>(std::abs(y))];
    int sum = 0;
    for (int x = -halfWidth; x <= halfWidth; ++x) {
      sum += middle[x];
      m10 += x * middle[x];
    }
    m01 += y * sum;
  }
  return cv::fastAtan2(static_cast<float>(m01), static_cast<float>(m10));
}

}  // namespace wardslam::features
