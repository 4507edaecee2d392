#include "sensors/kinect_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace wardslam::synth {
namespace {

/// Clears what lies in the projector's shadow: its rays meet a nearer thing first. The projector is to the right of
/// the camera, so shadows fall to the left of things.
void castProjectorShadow(cv::Mat& depth_m, const KinectOptions& options) {
  const auto fb = static_cast<float>(options.focal_px * options.baseline_m);
  for (int y = 0; y < depth_m.rows; ++y) {
    auto* row = depth_m.ptr<float>(y);
    float leftmostRay_px = std::numeric_limits<float>::max();  // of those already met, from the right
    for (int x = depth_m.cols - 1; x >= 0; --x) {
      if (row[x] <= 0) continue;
      const float ray_px = static_cast<float>(x) - fb / row[x];
      if (ray_px > leftmostRay_px) {
        row[x] = 0;
      } else {
        leftmostRay_px = ray_px;
      }
    }
  }
}

/// CV_8UC1, 255 where the depth jumps within a pixel's neighbourhood.
cv::Mat findEdges(const cv::Mat& depth_m, double jump) {
  cv::Mat nearest;
  cv::Mat farthest;
  const cv::Mat neighbourhood = cv::getStructuringElement(cv::MORPH_CROSS, {3, 3});
  cv::erode(depth_m, nearest, neighbourhood);
  cv::dilate(depth_m, farthest, neighbourhood);
  return (farthest - nearest) > jump * depth_m;
}

void punchHoles(cv::Mat& depth_m, const KinectOptions& options, cv::RNG& rng) {
  const cv::Mat edges = findEdges(depth_m, options.edgeJump);
  cv::Mat dice(depth_m.size(), CV_8UC1);
  rng.fill(dice, cv::RNG::UNIFORM, 0, 256);
  depth_m.setTo(0, edges & (dice < 256 * options.edgeHoles));
}

}  // namespace

double axialSigma_m(double z_m) { return 0.0012 + 0.0019 * (z_m - 0.4) * (z_m - 0.4); }

double quantisationStep_m(double z_m, const KinectOptions& options) {
  return z_m * z_m * options.disparityStep_px / (options.focal_px * options.baseline_m);
}

cv::Mat measureDepth(const cv::Mat& depth_m, const KinectOptions& options, std::uint64_t seed) {
  cv::Mat measured = depth_m.clone();
  if (options.depthNoise > 0) {
    cv::RNG rng(seed);
    castProjectorShadow(measured, options);
    punchHoles(measured, options, rng);
    cv::Mat noise(measured.size(), CV_32FC1);
    rng.fill(noise, cv::RNG::NORMAL, 0.0, options.depthNoise);
    const auto steps = static_cast<float>(options.focal_px * options.baseline_m / options.disparityStep_px);
    measured.forEach<float>([&](float& z_m, const int* at) {
      if (z_m <= 0) return;
      const float noisy_m =
          z_m + noise.at<float>(at[0], at[1]) * static_cast<float>(axialSigma_m(static_cast<double>(z_m)));
      z_m = steps / std::max(1.0F, std::round(steps / std::max(noisy_m, 0.05F)));
    });
  }
  measured.setTo(0, (measured < options.minDepth_m) | (measured > options.maxDepth_m));
  return measured;
}

cv::Mat exposeColor(const cv::Mat& color_bgr, const KinectOptions& options, std::uint64_t seed) {
  cv::RNG rng(seed);
  cv::Mat noise(color_bgr.size(), CV_16SC3);
  rng.fill(noise, cv::RNG::NORMAL, 0.0, options.imageNoise);
  const cv::Point2f centre(static_cast<float>(color_bgr.cols - 1) / 2, static_cast<float>(color_bgr.rows - 1) / 2);
  const float corner2 = centre.dot(centre);
  cv::Mat exposed(color_bgr.size(), CV_8UC3);
  const auto loss = static_cast<float>(options.vignetting);
  exposed.forEach<cv::Vec3b>([&](cv::Vec3b& out, const int* at) {
    const cv::Point2f r = cv::Point2f(static_cast<float>(at[1]), static_cast<float>(at[0])) - centre;
    const float gain = 1.0F - loss * r.dot(r) / corner2;
    const auto& in = color_bgr.at<cv::Vec3b>(at[0], at[1]);
    const auto& error = noise.at<cv::Vec3s>(at[0], at[1]);
    for (int c = 0; c < 3; ++c)
      out[c] = cv::saturate_cast<std::uint8_t>(gain * static_cast<float>(in[c]) + static_cast<float>(error[c]));
  });
  return exposed;
}

}  // namespace wardslam::synth
