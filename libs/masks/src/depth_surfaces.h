#pragma once

#include <cmath>
#include <opencv2/core.hpp>

/// Surfaces as a depth camera sees them. All work on inverse depth (1/m, CV_32FC1, 0 = not measured), where the noise
/// of structured light is nearly the same everywhere and a plane is linear in the pixel coordinates.
namespace wardslam::masks {

[[nodiscard]] cv::Mat inverseDepth(const cv::Mat& depth_m);

/// Whether neighbouring measured pixels may lie on one surface: their depths differ by less than 3 cm, or than three
/// times the noise of a Kinect (0.0019 z² m), whichever rules.
[[nodiscard]] inline bool isContinuous(float a, float b) {
  constexpr float kStep_m = 0.03F;
  constexpr float kNoise_per_m = 3 * 0.0019F;
  return a > 0 && b > 0 && std::abs(a - b) < kNoise_per_m + kStep_m * a * b;
}

/// The image cut into surfaces: 4-connected pixels, each continuous with its neighbours.
struct Surfaces {
  cv::Mat labels;  ///< CV_32SC1; 0 = not measured, else 1 … count-1.
  int count = 1;   ///< Of labels, 0 included.
};

/// Where the value of `parts` (CV_8UC1) changes, a surface ends.
[[nodiscard]] Surfaces findSurfaces(const cv::Mat& inverseDepth, const cv::Mat& parts);

}  // namespace wardslam::masks
