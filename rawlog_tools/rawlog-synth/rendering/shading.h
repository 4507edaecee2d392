#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <map>
#include <opencv2/core.hpp>
#include <vector>

#include "rendering/ray_casting.h"
#include "textures/textures.h"

namespace wardslam::synth {

/// What surfaces look like: their texture, lit by the lamps and the window.
class Shading {
 public:
  /// CV_8UC3 each, BGR.
  explicit Shading(const std::map<Material, cv::Mat>& textures);

  /// Of what a ray met, blue, green, red, 0..255; black where that is nothing.
  [[nodiscard]] Eigen::Array3f colourOf(const Hit& hit) const;

 private:
  std::vector<cv::Mat> textures_;  ///< CV_8UC4, by material.
};

/// Soft dark spots on the floor under what moves; the furniture's are painted on it. Each lies a little above the
/// floor, at its own height, upon those before it or hidden by them.
class FloorShadows {
 public:
  /// World frame.
  void add(const Eigen::AlignedBox2f& area_m, float z_m);

  /// None of them is higher. A ray from above is in none of them before it is down there.
  [[nodiscard]] float highest_m() const { return highest_m_; }

  /// The colour of a surface that is seen through them, `depth_m` along the ray.
  [[nodiscard]] Eigen::Array3f over(const Eigen::Array3f& colour, const Eigen::Vector3f& origin_m,
                                    const Eigen::Vector3f& direction, float depth_m) const;

 private:
  struct Spot {
    Eigen::Vector2f middle_m;
    Eigen::Vector2f perHalf;  ///< 1 / half of its size.
    float z_m;
  };
  std::vector<Spot> spots_;
  float highest_m_ = -std::numeric_limits<float>::infinity();
};

}  // namespace wardslam::synth
