#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

namespace wardslam::synth {

/// How a structured-light camera (Kinect v1 and its kin) measures depth, and how its colour camera sees.
struct KinectOptions {
  double depthNoise = 1.0;  ///< Scales the random error; 0 also turns quantisation and holes off.
  double minDepth_m = 0.4;
  double maxDepth_m = 8.0;
  double focal_px = 525.0;
  double baseline_m = 0.075;        ///< Between projector and infrared camera.
  double disparityStep_px = 0.125;  ///< Resolution of the disparity.
  double edgeJump = 0.04;           ///< Neighbours that differ by more than this part of the depth make an edge.
  double edgeHoles = 0.6;           ///< Share of the edge pixels without a measurement.
  double imageNoise = 1.6;          ///< Standard deviation, grey levels.
  double vignetting = 0.1;          ///< Loss of light in the corners.
};

/// Standard deviation of the depth at z_m: 0.0012 + 0.0019 (z − 0.4)² (Nguyen, Izadi, Lovell 2012, axial noise).
[[nodiscard]] double axialSigma_m(double z_m);

/// Step between neighbouring depths at z_m that the disparity can tell apart.
[[nodiscard]] double quantisationStep_m(double z_m, const KinectOptions& options);

/// depth_m (CV_32FC1, 0 = none) as the camera would have measured it: noise, quantised disparity, no depth where the
/// projector does not reach, at many edge pixels, and out of range. The same seed gives the same picture.
[[nodiscard]] cv::Mat measureDepth(const cv::Mat& depth_m, const KinectOptions& options, std::uint64_t seed);

/// Adds the colour camera's noise and vignetting to an image (CV_8UC3).
[[nodiscard]] cv::Mat exposeColor(const cv::Mat& color_bgr, const KinectOptions& options, std::uint64_t seed);

}  // namespace wardslam::synth
