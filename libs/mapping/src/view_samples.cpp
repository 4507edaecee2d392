#include "view_samples.h"

#include <cmath>
#include <unordered_map>

#include "cell_hash.h"

namespace wardslam::mapping {
namespace {

struct CellOfInstance {
  std::uint64_t cell = 0;
  std::uint16_t instance = 0;
  bool operator==(const CellOfInstance& other) const { return cell == other.cell && instance == other.instance; }
};

struct CellOfInstanceHash {
  std::size_t operator()(const CellOfInstance& key) const { return CellHash()(key.cell + 0x9E37U * key.instance); }
};

/// Sums become means.
void finish(Sample& sample, const core::DepthNoise& noise) {
  const auto n = static_cast<float>(sample.pixels);
  sample.p_map_m /= n;
  sample.color_rgb /= n;
  sample.depth_m /= n;
  sample.sigma_m = static_cast<float>(noise.sigma_m(static_cast<double>(sample.depth_m)));
}

}  // namespace

std::uint64_t cellOf(const Eigen::Vector3f& p_m, float side_m) {
  constexpr std::int64_t kOffset = 1 << 20;
  const auto part = [&](float x_m) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x_m / side_m)) + kOffset) & 0x1FFFFFU;
  };
  return part(p_m.x()) << 42U | part(p_m.y()) << 21U | part(p_m.z());
}

std::vector<Sample> sampleView(const View& view, const Eigen::Isometry3d& T_map_cam, const cv::Mat& rays,
                               const cv::Mat& usable, float cell_m, int pixel_step) {
  const Eigen::Isometry3f T = T_map_cam.cast<float>();
  const bool hasInstances = !view.segmentation.empty() && !view.segmentation.instanceIds.empty();
  std::vector<Sample> samples;
  std::unordered_map<CellOfInstance, std::size_t, CellOfInstanceHash> indexOf;
  for (int v = pixel_step / 2; v < view.depth_m.rows; v += pixel_step) {
    for (int u = pixel_step / 2; u < view.depth_m.cols; u += pixel_step) {
      if (usable.at<std::uint8_t>(v, u) == 0) continue;
      const float z_m = view.depth_m.at<float>(v, u);
      const auto& ray = rays.at<cv::Vec2f>(v, u);
      const Eigen::Vector3f p_map_m = T * Eigen::Vector3f(ray[0] * z_m, ray[1] * z_m, z_m);
      const std::uint16_t instance = hasInstances ? view.segmentation.instanceIds.at<std::uint16_t>(v, u) : 0;
      const auto [entry, isNew] = indexOf.try_emplace({cellOf(p_map_m, cell_m), instance}, samples.size());
      if (isNew) samples.emplace_back().instance = instance;
      Sample& sample = samples[entry->second];
      const auto& bgr = view.color_bgr.at<cv::Vec3b>(v, u);
      sample.p_map_m += p_map_m;
      sample.color_rgb += Eigen::Vector3f(bgr[2], bgr[1], bgr[0]);
      sample.depth_m += z_m;
      ++sample.pixels;
    }
  }
  for (Sample& sample : samples) finish(sample, view.camera.depthNoise);
  return samples;
}

}  // namespace wardslam::mapping
