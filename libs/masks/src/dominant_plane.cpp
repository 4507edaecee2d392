#include "dominant_plane.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace wardslam::masks {
namespace {

/// Inverse depth of a plane: a x + b y + c.
struct Plane {
  float a = 0.0F;
  float b = 0.0F;
  float c = 0.0F;

  /// Within 1 cm and the noise (of inverse depth, 1/m).
  [[nodiscard]] bool contains(const cv::Vec3f& p, float noise_per_m) const {
    constexpr float kRoughness_m = 0.01F;
    return std::abs(a * p[0] + b * p[1] + c - p[2]) < noise_per_m + kRoughness_m * p[2] * p[2];
  }
};

/// (x, y, inverse depth) of about `count` measured pixels.
std::vector<cv::Vec3f> sample(const cv::Mat& inverseDepth, const cv::Mat& among, std::size_t count) {
  std::vector<cv::Vec3f> all;
  for (int y = 0; y < among.rows; ++y) {
    const auto* row = among.ptr<std::uint8_t>(y);
    const auto* w = inverseDepth.ptr<float>(y);
    for (int x = 0; x < among.cols; ++x) {
      if (row[x] != 0 && w[x] > 0) all.emplace_back(static_cast<float>(x), static_cast<float>(y), w[x]);
    }
  }
  const std::size_t stride = std::max<std::size_t>(1, all.size() / count);
  std::vector<cv::Vec3f> some;
  for (std::size_t i = 0; i < all.size(); i += stride) some.push_back(all[i]);
  return some;
}

std::optional<Plane> planeThrough(const cv::Vec3f& p, const cv::Vec3f& q, const cv::Vec3f& r) {
  constexpr float kMinArea_px2 = 50;
  const cv::Vec3f u = q - p;
  const cv::Vec3f v = r - p;
  const float area = u[0] * v[1] - u[1] * v[0];
  if (std::abs(area) < kMinArea_px2) return std::nullopt;
  const float a = (u[2] * v[1] - u[1] * v[2]) / area;
  const float b = (u[0] * v[2] - u[2] * v[0]) / area;
  return Plane{a, b, p[2] - a * p[0] - b * p[1]};
}

Plane leastSquares(const std::vector<cv::Vec3f>& points, const Plane& first, float noise_per_m) {
  cv::Matx33d normal = cv::Matx33d::zeros();
  cv::Vec3d right = {0, 0, 0};
  for (const cv::Vec3f& p : points) {
    if (!first.contains(p, noise_per_m)) continue;
    const cv::Vec3d row(p[0], p[1], 1.0);
    normal += row * row.t();
    right += row * static_cast<double>(p[2]);
  }
  const cv::Vec3d solved = normal.solve(right, cv::DECOMP_CHOLESKY);
  return {static_cast<float>(solved[0]), static_cast<float>(solved[1]), static_cast<float>(solved[2])};
}

/// RANSAC.
std::optional<Plane> fitPlane(const std::vector<cv::Vec3f>& points, float noise_per_m) {
  constexpr int kTrials = 60;
  constexpr double kMinShare = 0.15;
  constexpr std::uint64_t kSeed = 7;
  if (points.size() < 50) return std::nullopt;
  cv::RNG random(kSeed);
  const auto any = [&] { return points[static_cast<std::size_t>(random.uniform(0, static_cast<int>(points.size())))]; };
  Plane best;
  auto most = static_cast<std::ptrdiff_t>(kMinShare * static_cast<double>(points.size()));
  bool isFound = false;
  for (int i = 0; i < kTrials; ++i) {
    const cv::Vec3f p = any();
    const cv::Vec3f q = any();
    const auto plane = planeThrough(p, q, any());
    if (!plane) continue;
    const auto on = std::count_if(points.begin(), points.end(),
                                  [&](const auto& point) { return plane->contains(point, noise_per_m); });
    if (on <= most) continue;
    most = on;
    best = *plane;
    isFound = true;
  }
  if (!isFound) return std::nullopt;
  return leastSquares(points, best, noise_per_m);
}

}  // namespace

cv::Mat dominantPlane(const cv::Mat& inverseDepth, const cv::Mat& among, const core::DepthNoise& noise) {
  const float noise_per_m = 2 * static_cast<float>(noise.growth_per_m);
  constexpr std::size_t kSamples = 300;
  cv::Mat onPlane(inverseDepth.size(), CV_8UC1, cv::Scalar(0));
  const auto plane = fitPlane(sample(inverseDepth, among, kSamples), noise_per_m);
  if (!plane) return onPlane;
  for (int y = 0; y < onPlane.rows; ++y) {
    const auto* w = inverseDepth.ptr<float>(y);
    auto* on = onPlane.ptr<std::uint8_t>(y);
    for (int x = 0; x < onPlane.cols; ++x) {
      const cv::Vec3f point(static_cast<float>(x), static_cast<float>(y), w[x]);
      on[x] = w[x] > 0 && plane->contains(point, noise_per_m) ? 255 : 0;
    }
  }
  return onPlane;
}

}  // namespace wardslam::masks
