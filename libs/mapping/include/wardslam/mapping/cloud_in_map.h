#pragma once

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::mapping {

/// Calls `take` with every point of the cloud and where it is in the map frame (m), tile by tile. Tiles that hang on no
/// keyframe of the map are left out.
template <class Take>
void forEachCloudPoint(const SemanticMap& map, const Take& take) {
  for (const auto& [id, tile] : map.cloud) {
    const auto keyframe = map.keyframes.find(id);
    if (keyframe == map.keyframes.end()) continue;
    const Eigen::Isometry3f T_map_cam = keyframe->second.T_map_cam.template cast<float>();
    for (const auto& point : tile.points) take(Eigen::Vector3f(T_map_cam * point.p_cam_m), point);
  }
}

}  // namespace wardslam::mapping
