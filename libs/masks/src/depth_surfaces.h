#pragma once

#include <cmath>
#include <opencv2/core.hpp>

#include "wardslam/core/depth_noise.h"

/// Surfaces as a depth camera sees them. All work on inverse depth (1/m, CV_32FC1, 0 = not measured), where noise that
/// grows with the square of the depth is the same everywhere and a plane is linear in the pixel coordinates. What of
/// the noise does not grow is less than the centimetres that surfaces are rough by.
namespace wardslam::masks {

[[nodiscard]] cv::Mat inverseDepth(const cv::Mat& depth_m);

/// Whether neighbouring measured pixels may lie on one surface: their depths differ by less than 3 cm and three times
/// the noise.
[[nodiscard]] inline bool isContinuous(float a, float b, const core::DepthNoise& noise) {
  constexpr float kStep_m = 0.03F;
  const float noise_per_m = 3 * static_cast<float>(noise.growth_per_m);
  return a > 0 && b > 0 && std::abs(a - b) < noise_per_m + kStep_m * a * b;
}

/// The image cut into surfaces: 4-connected pixels, each continuous with its neighbours.
struct Surfaces {
  cv::Mat labels;  ///< CV_32SC1; 0 = not measured, else 1 … count-1.
  int count = 1;   ///< Of labels, 0 included.
};

/// Where the value of `parts` (CV_8UC1) changes, a surface ends.
[[nodiscard]] Surfaces findSurfaces(const cv::Mat& inverseDepth, const cv::Mat& parts, const core::DepthNoise& noise);

}  // namespace wardslam::masks
