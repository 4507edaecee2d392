#include "wardslam/features/semantic_descriptor.h"

#include <cmath>
#include <cstdint>

#include "wardslam/core/segmentation.h"

namespace wardslam::features {
namespace {

/// Coordinates in 1/65536 px: enough for 2^-8 px over 255 steps, and images up to 16384 px still fit 32 bits.
constexpr int kFractionBits = 16;

std::int32_t toFixed(double value) { return static_cast<std::int32_t>(std::lround(value * (1 << kFractionBits))); }

/// To the nearest pixel.
std::int32_t toPixel(std::int32_t fixed) { return (fixed + (1 << (kFractionBits - 1))) >> kFractionBits; }

}  // namespace

cv::Mat describeSemantics(const cv::Mat& classIds, const core::Keypoint& keypoint, int n) {
  CV_Assert(classIds.type() == CV_8UC1 && n > 0 && n % 2 == 1);
  const double cosine = std::cos(static_cast<double>(keypoint.angle_rad));
  const double sine = std::sin(static_cast<double>(keypoint.angle_rad));
  const std::int32_t stepX = toFixed(cosine);
  const std::int32_t stepY = toFixed(sine);
  const int radius = n / 2;

  cv::Mat descriptor(n, n, CV_8UC1);
  for (int row = 0; row < n; ++row) {
    // Cell (row, 0) is at R(angle) * (-radius, row - radius) from the key point.
    std::int32_t x = toFixed(keypoint.raw_px.x - radius * cosine - (row - radius) * sine);
    std::int32_t y = toFixed(keypoint.raw_px.y - radius * sine + (row - radius) * cosine);
    auto* cells = descriptor.ptr<core::ClassId>(row);
    for (int col = 0; col < n; ++col, x += stepX, y += stepY) {
      const int u = toPixel(x);
      const int v = toPixel(y);
      const bool isInside = static_cast<unsigned>(u) < static_cast<unsigned>(classIds.cols) &&
                            static_cast<unsigned>(v) < static_cast<unsigned>(classIds.rows);
      cells[col] = isInside ? *classIds.ptr<core::ClassId>(v, u) : core::ClassId{0};
    }
  }
  return descriptor;
}

int semanticDistance(const cv::Mat& a, const cv::Mat& b) {
  CV_Assert(a.type() == CV_8UC1 && b.type() == CV_8UC1 && a.size() == b.size());
  return cv::countNonZero(a != b);
}

}  // namespace wardslam::features
