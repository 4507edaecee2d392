#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

#include "sensors/kinect_noise.h"

namespace wardslam::synth {

/// How the colour camera is exposed.
struct ExposureOptions {
  bool isDark = false;         ///< The light is off: what is left drowns in the noise of full gain.
  bool jumps = false;          ///< Every few seconds automatic exposure finds another brightness.
  double motionBlur_ms = 0.0;  ///< How long the shutter is open, around the stamp.
};

/// Brightness at t_s as a factor, 0.4 to 2.2: from a moment in each kJumpEvery_s on it nears, within some tenths of a
/// second, another value. Depends on nothing but its arguments.
[[nodiscard]] double gainAt(double t_s, std::uint32_t seed);
constexpr double kJumpEvery_s = 3.0;

/// An image as the chip gives it: brightness by light and gain (noise with it), then noise and vignetting.
[[nodiscard]] cv::Mat expose(const cv::Mat& light_bgr, const ExposureOptions& exposure, const KinectOptions& sensor,
                             double gain, std::uint64_t noiseSeed);

/// How many renderings over the exposure make a smear without steps, for a camera that moves its image so far.
[[nodiscard]] int blurSamples(double motion_px);

}  // namespace wardslam::synth
