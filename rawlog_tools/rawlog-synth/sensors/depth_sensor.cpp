#include "sensors/depth_sensor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace wardslam::synth {
namespace {

cv::Mat gaussian(const cv::Size& size, cv::RNG& rng) {
  cv::Mat noise(size, CV_32FC1);
  rng.fill(noise, cv::RNG::NORMAL, 0.0, 1.0);
  return noise;
}

struct Surroundings {
  cv::Mat nearest_m;  ///< Depths within reach of a pixel.
  cv::Mat farthest_m;
  cv::Mat isEdge;  ///< CV_8UC1
};

/// Pixels without depth count for none.
Surroundings lookAround(const cv::Mat& depth_m, int reach_px, double jump) {
  const cv::Mat window = cv::getStructuringElement(cv::MORPH_RECT, {2 * reach_px + 1, 2 * reach_px + 1});
  cv::Mat filled = depth_m.clone();
  filled.setTo(std::numeric_limits<float>::max(), depth_m <= 0);
  Surroundings around;
  cv::erode(filled, around.nearest_m, window);
  cv::dilate(depth_m, around.farthest_m, window);
  around.isEdge = ((around.farthest_m - around.nearest_m) > jump * depth_m) & (depth_m > 0);
  return around;
}

void keepRange(cv::Mat& depth_m, double min_m, double max_m) {
  depth_m.setTo(0, (depth_m < min_m) | (depth_m > max_m));
}

/// Share of the light that comes back, of the colours' brightness.
cv::Mat reflectivity(const cv::Mat& light_bgr) {
  cv::Mat gray;
  cv::cvtColor(light_bgr, gray, cv::COLOR_BGR2GRAY);
  cv::Mat share;
  gray.convertTo(share, CV_32F, 1.0 / 255.0);
  return cv::max(share, 0.02);
}

/// Pixels at edges come to lie anywhere between both sides.
void letFly(cv::Mat& depth_m, const TofOptions& options, cv::RNG& rng) {
  const Surroundings around = lookAround(depth_m, 1, options.edgeJump);
  cv::Mat dice(depth_m.size(), CV_32FC2);
  rng.fill(dice, cv::RNG::UNIFORM, 0.0, 1.0);
  depth_m.forEach<float>([&](float& z_m, const int* at) {
    const auto& [decides, share] = dice.at<cv::Vec2f>(at[0], at[1]).val;
    if (around.isEdge.at<std::uint8_t>(at[0], at[1]) == 0 || static_cast<double>(decides) > options.flyingShare) return;
    const float nearest_m = around.nearest_m.at<float>(at[0], at[1]);
    z_m = nearest_m + share * (around.farthest_m.at<float>(at[0], at[1]) - nearest_m);
  });
}

/// The right camera, a baseline to the right, does not see what lies just left of a near thing.
void hideFromRightCamera(cv::Mat& depth_m, double fb) {
  for (int y = 0; y < depth_m.rows; ++y) {
    auto* row = depth_m.ptr<float>(y);
    double leftmost_px = std::numeric_limits<double>::max();
    for (int x = depth_m.cols - 1; x >= 0; --x) {
      if (row[x] <= 0) continue;
      const double seenAt_px = x - fb / static_cast<double>(row[x]);
      if (seenAt_px > leftmost_px) row[x] = 0;
      leftmost_px = std::min(leftmost_px, seenAt_px);
    }
  }
}

}  // namespace

double tofSigma_m(double z_m, double reflectivity, const TofOptions& options) {
  return options.floor_m + options.shot_m_per_m * z_m / std::sqrt(reflectivity);
}

double stereoSigma_m(double z_m, double focal_px, const StereoDepthOptions& options) {
  return z_m * z_m * options.disparitySigma_px / (focal_px * options.baseline_m);
}

cv::Mat measureByTof(const cv::Mat& depth_m, const cv::Mat& light_bgr, double noise, std::uint64_t seed,
                     const TofOptions& options) {
  cv::Mat measured = depth_m.clone();
  if (noise > 0) {
    cv::RNG rng(seed);
    const cv::Mat share = reflectivity(light_bgr);
    letFly(measured, options, rng);
    const cv::Mat error = gaussian(measured.size(), rng);
    measured.forEach<float>([&](float& z_m, const int* at) {
      if (z_m <= 0) return;
      const auto rho = static_cast<double>(share.at<float>(at[0], at[1]));
      const double z = static_cast<double>(z_m);
      const bool isLost = rho < options.least_return * z * z;
      const double off_m = noise * tofSigma_m(z, rho, options) * static_cast<double>(error.at<float>(at[0], at[1]));
      z_m = isLost ? 0.0F : static_cast<float>(z + off_m);
    });
  }
  keepRange(measured, options.minDepth_m, options.maxDepth_m);
  return measured;
}

cv::Mat measureByStereo(const cv::Mat& depth_m, double focal_px, double noise, std::uint64_t seed,
                        const StereoDepthOptions& options) {
  cv::Mat measured = depth_m.clone();
  if (noise > 0) {
    cv::RNG rng(seed);
    const double fb = focal_px * options.baseline_m;
    hideFromRightCamera(measured, fb);
    const int half_px = std::max(1, static_cast<int>(std::lround(options.block_px * measured.cols / 1280.0)));
    const Surroundings around = lookAround(measured, half_px, options.edgeJump);
    around.nearest_m.copyTo(measured, around.isEdge);
    // Errors are alike within half a block; blurring divides σ by the window's side.
    cv::Mat error = gaussian(measured.size(), rng);
    const int window_px = half_px + 1;
    cv::blur(error, error, {window_px, window_px});
    const double sigma_px = noise * options.disparitySigma_px * window_px;
    measured.forEach<float>([&](float& z_m, const int* at) {
      if (z_m <= 0) return;
      const double d_px = fb / static_cast<double>(z_m) + sigma_px * static_cast<double>(error.at<float>(at[0], at[1]));
      const double steps = std::max(1.0, std::round(d_px / options.disparityStep_px));
      z_m = static_cast<float>(fb / (steps * options.disparityStep_px));
    });
  }
  keepRange(measured, options.minDepth_m, options.maxDepth_m);
  return measured;
}

}  // namespace wardslam::synth
