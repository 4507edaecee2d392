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

/// Harris and Stephens' measure of a corner, over 7 x 7 pixels with Sobel's derivatives, in units of the squared
/// squared slope of the grey values.
float harrisResponse(const cv::Mat& level, const cv::Point& centre) {
  constexpr int kReach_px = 3;
  constexpr double kEdges = 0.04;  // how much of one slope alone is held against it
  constexpr double kPerUnit = 1.0 / (4.0 * 7.0 * 255.0);
  int xx = 0;
  int yy = 0;
  int xy = 0;
  for (int y = centre.y - kReach_px; y <= centre.y + kReach_px; ++y) {
    const auto* above = level.ptr<std::uint8_t>(y - 1);
    const auto* here = level.ptr<std::uint8_t>(y);
    const auto* below = level.ptr<std::uint8_t>(y + 1);
    for (int x = centre.x - kReach_px; x <= centre.x + kReach_px; ++x) {
      const int dx = above[x + 1] - above[x - 1] + 2 * (here[x + 1] - here[x - 1]) + below[x + 1] - below[x - 1];
      const int dy = below[x - 1] - above[x - 1] + 2 * (below[x] - above[x]) + below[x + 1] - above[x + 1];
      xx += dx * dx;
      yy += dy * dy;
      xy += dx * dy;
    }
  }
  const double a = xx * kPerUnit * kPerUnit;
  const double b = yy * kPerUnit * kPerUnit;
  const double c = xy * kPerUnit * kPerUnit;
  return static_cast<float>(a * b - c * c - kEdges * (a + b) * (a + b));
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
  constexpr int kLooked = 2;  // at so many times as many: FAST tells where corners are, but not so well how good
  std::vector<cv::KeyPoint> corners;
  cv::FAST(level, corners, fastThreshold, /*nonmaxSuppression=*/true);
  cv::KeyPointsFilter::runByImageBorder(corners, level.size(), kBorder_px);
  cv::KeyPointsFilter::retainBest(corners, kLooked * static_cast<int>(most));
  for (cv::KeyPoint& corner : corners) corner.response = harrisResponse(level, corner.pt);
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
