#include "color_evidence.h"

#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace wardslam::masks {
namespace {

constexpr std::size_t kBins = 4096;  // four bits per channel

std::size_t binOf(const cv::Vec3b& bgr) {
  return static_cast<std::size_t>((bgr[0] >> 4) << 8 | (bgr[1] >> 4) << 4 | bgr[2] >> 4);
}

struct Histogram {
  std::array<float, kBins> count{};
  float total = 1.0F;

  [[nodiscard]] float probability(std::size_t bin) const {
    constexpr float kUnseen = 1.0F / kBins;  // for both sides alike, so that it cancels
    return count[bin] / total + kUnseen;
  }
};

Histogram colorsOf(const cv::Mat& color_bgr, const cv::Mat& mask) {
  Histogram histogram;
  for (int y = 0; y < mask.rows; ++y) {
    const auto* color = color_bgr.ptr<cv::Vec3b>(y);
    const auto* isIn = mask.ptr<std::uint8_t>(y);
    for (int x = 0; x < mask.cols; ++x) {
      if (isIn[x] == 0) continue;
      ++histogram.count[binOf(color[x])];
      ++histogram.total;
    }
  }
  return histogram;
}

}  // namespace

cv::Mat backgroundEvidence(const cv::Mat& color_bgr, const cv::Mat& thing, const cv::Mat& background) {
  const Histogram ofThing = colorsOf(color_bgr, thing);
  const Histogram ofBackground = colorsOf(color_bgr, background);
  std::array<float, kBins> ratio{};
  for (std::size_t i = 0; i < kBins; ++i) ratio[i] = std::log(ofBackground.probability(i) / ofThing.probability(i));

  cv::Mat evidence(color_bgr.size(), CV_32FC1);
  for (int y = 0; y < evidence.rows; ++y) {
    const auto* color = color_bgr.ptr<cv::Vec3b>(y);
    auto* row = evidence.ptr<float>(y);
    for (int x = 0; x < evidence.cols; ++x) row[x] = ratio[binOf(color[x])];
  }
  cv::blur(evidence, evidence, {5, 5});
  return evidence;
}

}  // namespace wardslam::masks
