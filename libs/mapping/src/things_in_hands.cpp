#include "things_in_hands.h"

#include <map>

namespace wardslam::mapping {
namespace {

constexpr int kStep_px = 4;

struct Count {
  int pixels = 0;
  int suspected = 0;
  int measured = 0;
  Eigen::Vector3d sum_m = Eigen::Vector3d::Zero();
};

std::map<std::uint16_t, Count> countPixels(const View& view) {
  std::map<std::uint16_t, Count> counts;
  for (int v = 0; v < view.mayMove.rows; v += kStep_px) {
    for (int u = 0; u < view.mayMove.cols; u += kStep_px) {
      const auto instance = view.segmentation.instanceIds.at<std::uint16_t>(v, u);
      if (instance == 0) continue;
      Count& count = counts[instance];
      ++count.pixels;
      if (view.mayMove.at<std::uint8_t>(v, u) != 0) ++count.suspected;
      const double z_m = view.depth_m.at<float>(v, u);
      if (z_m <= 0) continue;
      ++count.measured;
      count.sum_m += view.camera.unproject({u, v}, z_m);  // where exactly does not matter
    }
  }
  return counts;
}

}  // namespace

std::vector<Handled> thingsInHands(const View& view, const knowledge::ClassSet& moving) {
  if (view.mayMove.empty() || view.segmentation.instanceIds.empty()) return {};
  const auto counts = countPixels(view);
  std::vector<Handled> things;
  for (const core::Instance& instance : view.segmentation.instances) {
    const auto entry = counts.find(instance.id);
    if (entry == counts.end() || instance.classId == 0 || moving[instance.classId]) continue;
    const Count& count = entry->second;
    if (2 * count.suspected < count.pixels || count.measured == 0) continue;
    things.push_back({instance.classId, count.sum_m / count.measured});
  }
  return things;
}

}  // namespace wardslam::mapping
