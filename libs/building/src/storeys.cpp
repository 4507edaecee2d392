#include "wardslam/building/storeys.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace wardslam::building {
namespace {

constexpr double kStoreyGap_m = 1.0;  // no ground in between: another storey
constexpr double kSunk_m = 0.5;       // into a floor that rises somewhere else

struct Foot {
  Eigen::Vector3d eye_m;
  double floor_m = 0.0;
};

std::vector<Foot> feetOf(const mapping::SemanticMap& map) {
  std::vector<Foot> feet;
  for (const auto& [id, keyframe] : map.keyframes) {
    if (keyframe.piece != map.piece || !keyframe.ground) continue;
    const Eigen::Vector3d eye_m = keyframe.T_map_cam.translation();
    const Eigen::Vector3d up_map = keyframe.T_map_cam.linear() * keyframe.ground->normal_cam;
    feet.push_back({eye_m, eye_m.z() - keyframe.ground->height_m * up_map.z()});
  }
  return feet;
}

/// Where nobody saw the floor it is that of the nearest keyframe that did.
double floorUnder(const Eigen::Vector3d& eye_m, const std::vector<Foot>& feet) {
  return std::min_element(feet.begin(), feet.end(),
                          [&](const Foot& a, const Foot& b) {
                            return (a.eye_m - eye_m).squaredNorm() < (b.eye_m - eye_m).squaredNorm();
                          })
      ->floor_m;
}

}  // namespace

std::vector<Storey> storeysOf(const mapping::SemanticMap& map) {
  const auto feet = feetOf(map);
  std::vector<std::pair<double, std::uint64_t>> byHeight;
  if (feet.empty()) return {};
  for (const auto& [id, keyframe] : map.keyframes) {
    if (keyframe.piece == map.piece) byHeight.emplace_back(floorUnder(keyframe.T_map_cam.translation(), feet), id);
  }
  std::sort(byHeight.begin(), byHeight.end());
  std::vector<Storey> storeys;
  for (const auto& [floor_m, id] : byHeight) {
    if (storeys.empty() || floor_m - storeys.back().highest_m > kStoreyGap_m) storeys.push_back({floor_m, floor_m, {}});
    storeys.back().highest_m = floor_m;
    storeys.back().keyframes.insert(id);
  }
  std::max_element(storeys.begin(), storeys.end(), [](const Storey& a, const Storey& b) {
    return a.keyframes.size() < b.keyframes.size();
  })->hasPlan = true;
  return storeys;
}

const Storey& storeyAt(const std::vector<Storey>& storeys, double z_map_m) {
  const auto isOver = [z_map_m](const Storey& storey) { return storey.lowest_m > z_map_m + kSunk_m; };
  const auto above = std::find_if(storeys.begin(), storeys.end(), isOver);
  return above == storeys.begin() ? storeys.front() : *std::prev(above);
}

bool isOnPlan(const std::vector<Storey>& storeys, double z_map_m) {
  return storeys.empty() || storeyAt(storeys, z_map_m).hasPlan;
}

}  // namespace wardslam::building
