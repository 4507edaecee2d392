#include "sensors/exposure.h"

#include <algorithm>
#include <cmath>

namespace wardslam::synth {
namespace {

constexpr double kLightLeft = 0.02;  ///< Of the light, when it is off.
constexpr double kDarkNoise = 4.0;   ///< Times the noise in good light.
constexpr double kSettling_s = 0.15;

struct Jump {
  double at_s = 0.0;
  double gain = 1.0;
};

/// The jump within the k-th stretch of time.
Jump jumpOf(long k, std::uint32_t seed) {
  if (k < 0) return {};
  cv::RNG rng((static_cast<std::uint64_t>(seed) << 32U) + 0x9E3779B9U * static_cast<std::uint64_t>(k + 1));
  for (int i = 0; i < 4; ++i) rng.next();  // neighbouring states begin alike
  const double at = rng.uniform(0.1, 0.7);
  const double stops = rng.uniform(0.6, 1.15);
  return {(static_cast<double>(k) + at) * kJumpEvery_s, std::exp2(rng.uniform(0, 2) == 0 ? -stops : stops)};
}

}  // namespace

double gainAt(double t_s, std::uint32_t seed) {
  const auto k = static_cast<long>(std::floor(t_s / kJumpEvery_s));
  Jump before = jumpOf(k - 1, seed);
  Jump last = jumpOf(k, seed);
  if (last.at_s > t_s) {
    last = before;
    before = jumpOf(k - 2, seed);
  }
  const double settled = 1.0 - std::exp(-(t_s - last.at_s) / kSettling_s);
  return std::exp2(std::log2(before.gain) + settled * (std::log2(last.gain) - std::log2(before.gain)));
}

cv::Mat expose(const cv::Mat& light_bgr, const ExposureOptions& exposure, const KinectOptions& sensor, double gain,
               std::uint64_t noiseSeed) {
  KinectOptions chip = sensor;
  double brightness = 1.0;
  if (exposure.jumps) {
    brightness *= gain;
    chip.imageNoise *= std::max(1.0, gain);
  }
  if (exposure.isDark) {
    brightness *= kLightLeft;
    chip.imageNoise *= kDarkNoise;
  }
  if (brightness == 1.0) return exposeColor(light_bgr, chip, noiseSeed);
  cv::Mat lit;
  light_bgr.convertTo(lit, CV_8U, brightness);
  return exposeColor(lit, chip, noiseSeed);
}

int blurSamples(double motion_px) {
  constexpr int kMost = 12;  // then steps show, but only where it smears over more than twice as many pixels
  return std::clamp(static_cast<int>(std::ceil(motion_px / 2.0)) + 1, 3, kMost);
}

}  // namespace wardslam::synth
