#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

#include "sensors/kinect_noise.h"

namespace wardslam::synth {

/// Perfect: true depth within the Kinect's range. Kinect: structured light (kinect_noise.h). Tof: time of flight, after
/// the Kinect v2. Stereo: active stereo, after the RealSense D400.
enum class DepthSensor { Kinect, Tof, Stereo, Perfect };

/// Time of flight. What limits it is the shot noise of the light that comes back, which falls with the square of the
/// distance and with how dark the surface is: σ ~ z / √ρ, over a floor (Lange and Seitz, "Solid-state time-of-flight
/// range camera", 2001; the figures are of the order that Fankhauser et al., "Kinect v2 for mobile robot navigation",
/// 2015, measured). A pixel on an edge mixes the light of both sides: "flying pixels" between them.
struct TofOptions {
  double floor_m = 0.0015;       ///< σ of a white surface close by.
  double shot_m_per_m = 0.0015;  ///< What σ of a white surface grows with each metre.
  double least_return = 0.003;   ///< ρ / z² below which nothing is measured.
  double edgeJump = 0.03;        ///< Neighbours that differ by more than this part of the depth make an edge.
  double flyingShare = 0.7;      ///< Of the pixels at edges.
  double minDepth_m = 0.5;
  double maxDepth_m = 8.0;
};

/// Active stereo. A disparity error of a fraction of a pixel makes σ = z² σ_d / (f b) (Keselman et al., "Intel
/// RealSense stereoscopic depth cameras", 2017). Blocks are matched: errors are alike over some pixels, what is near
/// grows by half a block, and the left rim of near things hides from one camera what the other sees.
struct StereoDepthOptions {
  double baseline_m = 0.05;
  double disparitySigma_px = 0.08;
  double disparityStep_px = 1.0 / 32;
  int block_px = 7;  ///< At a width of 640 pixels.
  double edgeJump = 0.05;
  double minDepth_m = 0.2;
  double maxDepth_m = 10.0;
};

/// Standard deviation of a time-of-flight measurement; `reflectivity` in (0, 1].
[[nodiscard]] double tofSigma_m(double z_m, double reflectivity, const TofOptions& options = {});
/// Of active stereo with that focal length.
[[nodiscard]] double stereoSigma_m(double z_m, double focal_px, const StereoDepthOptions& options = {});

/// depth_m (CV_32FC1, 0 = none) as a time-of-flight camera measures it. light_bgr (CV_8UC3) is what the surfaces look
/// like in good light: dark ones return little. `noise` scales the random error; 0 leaves the range alone.
[[nodiscard]] cv::Mat measureByTof(const cv::Mat& depth_m, const cv::Mat& light_bgr, double noise, std::uint64_t seed,
                                   const TofOptions& options = {});
/// As an active stereo camera of that focal length measures it.
[[nodiscard]] cv::Mat measureByStereo(const cv::Mat& depth_m, double focal_px, double noise, std::uint64_t seed,
                                      const StereoDepthOptions& options = {});

}  // namespace wardslam::synth
