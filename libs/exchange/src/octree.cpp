#include "octree.h"

#include "wardslam/mapping/cloud_in_map.h"

namespace wardslam::exchange {
namespace {

octomap::point3d toOctomap(const Eigen::Vector3f& p) { return {p.x(), p.y(), p.z()}; }

/// What lies between a camera and what it saw is free.
void clearWays(octomap::OcTree& tree, const mapping::SemanticMap& map) {
  for (const auto& [id, tile] : map.cloud) {
    const auto keyframe = map.keyframes.find(id);
    if (keyframe == map.keyframes.end()) continue;
    const Eigen::Isometry3f T_map_cam = keyframe->second.T_map_cam.cast<float>();
    octomap::Pointcloud seen;
    for (const auto& point : tile.points) seen.push_back(toOctomap(T_map_cam * point.p_cam_m));
    constexpr double kAnyRange = -1.0;
    tree.insertPointCloud(seen, toOctomap(T_map_cam.translation()), kAnyRange, /*lazy_eval=*/true, /*discretize=*/true);
  }
}

/// Rays that pass close by wear thin surfaces away; the cloud knows better.
void occupyCloud(octomap::OcTree& tree, const mapping::SemanticMap& map) {
  mapping::forEachCloudPoint(map, [&tree](const Eigen::Vector3f& p_map_m, const mapping::SemanticPoint& /*point*/) {
    tree.setNodeValue(toOctomap(p_map_m), tree.getClampingThresMaxLog(), /*lazy_eval=*/true);
  });
}

}  // namespace

void fillOctree(const mapping::SemanticMap& map, octomap::OcTree& tree) {
  clearWays(tree, map);
  occupyCloud(tree, map);
  tree.updateInnerOccupancy();
}

}  // namespace wardslam::exchange
