#include "wardslam/features/semantic_descriptor.h"

#include <cmath>
#include <cstdint>

#include "wardslam/core/segmentation.h"

namespace wardslam::features {
namespace {

/// Coordinates in 1/65536 px: enough for 0.002 px over the largest patch, and images up to 16384 px still fit 32 bits.
constexpr int kFractionBits = 16;

std::int32_t toFixed(double value) { return static_cast<std::int32_t>(std::lround(value * (1 << kFractionBits))); }

/// Writes the n×n cells, row by row. Coordinates are kept half a pixel high, so that cutting the fraction off gives
/// the nearest pixel.
class PatchSampler {
 public:
  PatchSampler(const cv::Mat& classIds, int n) : classIds_(classIds), n_(n) {
    CV_Assert(classIds.type() == CV_8UC1 && n > 0 && n % 2 == 1);
  }

  void sample(const core::Keypoint& keypoint, core::ClassId* cells) const {
    const std::int32_t stepX = toFixed(std::cos(static_cast<double>(keypoint.angle_rad)));
    const std::int32_t stepY = toFixed(std::sin(static_cast<double>(keypoint.angle_rad)));
    const std::int32_t centreX = toFixed(keypoint.raw_px.x + 0.5);
    const std::int32_t centreY = toFixed(keypoint.raw_px.y + 0.5);
    const bool isInside = reachesOnlyPixels(keypoint.raw_px);
    const int radius = n_ / 2;
    for (int dy = -radius; dy <= radius; ++dy, cells += n_) {
      // The first cell of the row is at R(angle) * (-radius, dy) from the key point.
      const std::int32_t x = centreX - radius * stepX - dy * stepY;
      const std::int32_t y = centreY - radius * stepY + dy * stepX;
      isInside ? sampleInside(x, y, stepX, stepY, cells) : sampleAnywhere(x, y, stepX, stepY, cells);
    }
  }

 private:
  [[nodiscard]] bool reachesOnlyPixels(cv::Point2f centre) const {
    const auto reach = 0.7072F * static_cast<float>(n_) + 1.0F;
    return centre.x >= reach && centre.y >= reach && centre.x < static_cast<float>(classIds_.cols) - reach &&
           centre.y < static_cast<float>(classIds_.rows) - reach;
  }

  void sampleInside(std::int32_t x, std::int32_t y, std::int32_t stepX, std::int32_t stepY,
                    core::ClassId* cells) const {
    const auto* pixels = classIds_.ptr<core::ClassId>();
    const auto pitch = static_cast<std::int32_t>(classIds_.step);
    for (int col = 0; col < n_; ++col, x += stepX, y += stepY) {
      cells[col] = pixels[(y >> kFractionBits) * pitch + (x >> kFractionBits)];
    }
  }

  void sampleAnywhere(std::int32_t x, std::int32_t y, std::int32_t stepX, std::int32_t stepY,
                      core::ClassId* cells) const {
    const cv::Rect image({}, classIds_.size());
    for (int col = 0; col < n_; ++col, x += stepX, y += stepY) {
      const cv::Point pixel(x >> kFractionBits, y >> kFractionBits);
      cells[col] = image.contains(pixel) ? classIds_.at<core::ClassId>(pixel) : core::ClassId{0};
    }
  }

  cv::Mat classIds_;
  int n_;
};

}  // namespace

cv::Mat describeSemantics(const cv::Mat& classIds, const core::Keypoint& keypoint, int n) {
  const PatchSampler sampler(classIds, n);
  cv::Mat descriptor(n, n, CV_8UC1);
  sampler.sample(keypoint, descriptor.ptr<core::ClassId>());
  return descriptor;
}

cv::Mat describeSemantics(const cv::Mat& classIds, const std::vector<core::Keypoint>& keypoints, int n) {
  const PatchSampler sampler(classIds, n);
  cv::Mat descriptors(static_cast<int>(keypoints.size()), n * n, CV_8UC1);
  for (int i = 0; i < descriptors.rows; ++i) {
    sampler.sample(keypoints[static_cast<std::size_t>(i)], descriptors.ptr<core::ClassId>(i));
  }
  return descriptors;
}

core::SemanticDescriptor SemanticDescriptors::of(const core::Keypoint& keypoint) const {
  core::SemanticDescriptor cells(static_cast<std::size_t>(n_) * static_cast<std::size_t>(n_));
  PatchSampler(classIds_, n_).sample(keypoint, cells.data());
  return cells;
}

}  // namespace wardslam::features
