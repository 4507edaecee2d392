#include "rendering/shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

namespace wardslam::synth {
namespace {

constexpr float kAmbient = 0.74F;
constexpr float kDiffuse = 0.36F;

const Eigen::Vector3f& towardsLight() {
  static const Eigen::Vector3f direction = Eigen::Vector3f(0.38F, -0.23F, 0.89F).normalized();
  return direction;
}

int floorOf(float x) {
  const int i = static_cast<int>(x);
  return static_cast<float>(i) > x ? i - 1 : i;
}

/// Two neighbouring texels of a texture that repeats, and where between them.
struct Between {
  int first;
  int second;
  float share;

  Between(float turns, int texels) {
    const float at = (turns - static_cast<float>(floorOf(turns))) * static_cast<float>(texels) - 0.5F;
    first = floorOf(at);
    share = at - static_cast<float>(first);
    second = first + 1;
    if (first < 0) first = texels - 1;
    if (first >= texels) first = texels - 1;
    if (second >= texels) second = 0;
  }
};

/// Blue, green and red, 0..255, between four texels (0xXXRRGGBB) whose weights sum up to 256. Two channels are weighed
/// at once, each in 16 bits.
Eigen::Array3f weighed(const std::array<std::uint32_t, 4>& texels, const std::array<std::uint32_t, 4>& weights) {
  constexpr std::uint32_t kOuter = 0x00FF00FFU;
  std::uint32_t blueAndRed = 0;
  std::uint32_t green = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    blueAndRed += (texels[i] & kOuter) * weights[i];
    green += ((texels[i] >> 8U) & 0xFFU) * weights[i];
  }
  const auto level = [](std::uint32_t sum) { return static_cast<float>(static_cast<int>(sum)) / 256.0F; };
  return {level(blueAndRed & 0xFFFFU), level(green), level(blueAndRed >> 16U)};
}

Eigen::Array3f sampled(const cv::Mat& texture, const Eigen::Vector2f& uv) {
  const Between x(uv.x(), texture.cols);
  const Between y(uv.y(), texture.rows);
  const auto* upper = texture.ptr<std::uint32_t>(y.first);
  const auto* lower = texture.ptr<std::uint32_t>(y.second);
  const auto right = static_cast<std::uint32_t>(static_cast<int>(256.0F * x.share));
  const auto down = static_cast<std::uint32_t>(static_cast<int>(256.0F * y.share));
  const std::uint32_t both = (right * down + 128U) >> 8U;
  return weighed({upper[x.first], upper[x.second], lower[x.first], lower[x.second]},
                 {256U + both - right - down, right - both, down - both, both});
}

float lightOn(const Eigen::Vector3f& normal) {
  return kAmbient + kDiffuse * std::max(0.0F, normal.normalized().dot(towardsLight()));
}

}  // namespace

Shading::Shading(const std::map<Material, cv::Mat>& textures) {
  for (const auto& [material, texture] : textures) {
    const auto index = static_cast<std::size_t>(material);
    if (textures_.size() <= index) textures_.resize(index + 1);
    cv::cvtColor(texture, textures_[index], cv::COLOR_BGR2BGRA);
  }
}

Eigen::Array3f Shading::colourOf(const Hit& hit) const {
  if (hit.piece == nullptr) return Eigen::Array3f::Zero();
  const Vertex* corner = hit.corners;
  const float w = 1.0F - hit.u - hit.v;
  const Eigen::Vector2f uv = w * corner[0].uv + hit.u * corner[1].uv + hit.v * corner[2].uv;
  const Eigen::Vector3f normal = w * corner[0].normal + hit.u * corner[1].normal + hit.v * corner[2].normal;
  return (lightOn(normal) * sampled(textures_[static_cast<std::size_t>(hit.piece->material)], uv)).min(255.0F);
}

void FloorShadows::add(const Eigen::AlignedBox2f& area_m, float z_m) {
  spots_.push_back({area_m.center(), 2.0F * area_m.sizes().cwiseInverse(), z_m});
  highest_m_ = std::max(highest_m_, z_m);
}

Eigen::Array3f FloorShadows::over(const Eigen::Array3f& colour, const Eigen::Vector3f& origin_m,
                                  const Eigen::Vector3f& direction, float depth_m) const {
  constexpr float kDarkest = 0.89F;  // in the middle, 1 being the shadow's own colour
  constexpr float kOwnColour = 20.0F;
  static const float lit = kOwnColour * lightOn(Eigen::Vector3f::UnitZ());
  Eigen::Array3f out = colour;
  const float perMetre = 1.0F / direction.z();
  for (const Spot& spot : spots_) {
    const float there_m = (spot.z_m - origin_m.z()) * perMetre;
    if (!(there_m > 0.0F && there_m < depth_m)) continue;
    const float x = (origin_m.x() + there_m * direction.x() - spot.middle_m.x()) * spot.perHalf.x();
    const float y = (origin_m.y() + there_m * direction.y() - spot.middle_m.y()) * spot.perHalf.y();
    if (std::max(std::abs(x), std::abs(y)) > 1.0F) continue;
    depth_m = there_m;  // what lies lower is hidden
    const float inside = std::max(0.0F, 1.0F - x * x - y * y);
    out += kDarkest * inside * inside * (lit - out);
  }
  return out;
}

}  // namespace wardslam::synth
