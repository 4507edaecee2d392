#include "seen_through.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace wardslam::mapping {
namespace {

constexpr float kBin =
    0.02F;  // of tangents: width of a line of sight, 6 cm at 3 m, as far apart as points of the cloud
constexpr float kLeastGap_m = 0.15F;  // what is nearer behind may be a part of the thing
constexpr float kNearest_m = 0.1F;

using Sight = std::pair<int, int>;

Sight sightOf(const Eigen::Vector3f& p_cam_m) {
  return {static_cast<int>(std::floor(p_cam_m.x() / p_cam_m.z() / kBin)),
          static_cast<int>(std::floor(p_cam_m.y() / p_cam_m.z() / kBin))};
}

/// How far each line of sight of the tile's keyframe reaches, of those asked for.
void lookAlong(const Tile& tile, std::map<Sight, float>& reach_m) {
  for (const CloudPoint& point : tile.points) {
    if (point.p_cam_m.z() < kNearest_m) continue;
    const auto sight = reach_m.find(sightOf(point.p_cam_m));
    if (sight != reach_m.end()) sight->second = std::max(sight->second, point.p_cam_m.z());
  }
}

/// Marks the places that the tile's keyframe saw through.
void markSeenThrough(const Tile& tile, const std::vector<Eigen::Vector3f>& places_m, std::vector<bool>& isSeenThrough) {
  const Eigen::Isometry3f T_cam_map = tile.T_map_cam.inverse();
  std::map<Sight, float> reach_m;
  for (const auto& place_m : places_m) {
    const Eigen::Vector3f p_cam_m = T_cam_map * place_m;
    if (p_cam_m.z() > kNearest_m) reach_m.emplace(sightOf(p_cam_m), 0.0F);
  }
  if (reach_m.empty()) return;
  lookAlong(tile, reach_m);
  for (std::size_t i = 0; i < places_m.size(); ++i) {
    const Eigen::Vector3f p_cam_m = T_cam_map * places_m[i];
    if (p_cam_m.z() <= kNearest_m) continue;
    if (reach_m.at(sightOf(p_cam_m)) > p_cam_m.z() + kLeastGap_m) isSeenThrough[i] = true;
  }
}

}  // namespace

bool wasSeenThrough(const SemanticCloud& cloud, const std::vector<Eigen::Vector3f>& places_m, double range_m) {
  if (places_m.empty()) return false;
  std::vector<bool> isSeenThrough(places_m.size(), false);
  for (const Tile& tile : cloud.tiles()) {
    if (tile.points.empty()) continue;
    const float distance_m = (tile.T_map_cam.translation() - places_m.front()).norm();
    if (distance_m < static_cast<float>(range_m)) markSeenThrough(tile, places_m, isSeenThrough);
  }
  const auto seen = std::count(isSeenThrough.begin(), isSeenThrough.end(), true);
  return 2 * static_cast<std::size_t>(seen) >= places_m.size();
}

}  // namespace wardslam::mapping
