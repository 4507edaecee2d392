#include "wardslam/graph/saved_graph.h"

#include <algorithm>

#include "wardslam/odometry/pieces.h"

namespace wardslam::graph {

SavedGraph save(const KeyframeGraph& graph) {
  SavedGraph saved;
  odometry::Pieces pieces;
  for (const auto& [id, node] : graph.keyframes()) {
    auto keyframe = std::make_shared<odometry::Keyframe>(*node.keyframe);
    saved.freeSubmap = std::max({saved.freeSubmap, keyframe->submap + 1, node.submap + 1});
    pieces.add(id, node.submap);
    keyframe->T_map_cam = node.T_map_cam;
    keyframe->submap = node.submap;
    keyframe->sightings.clear();
    for (const auto& [point, keypoint] : node.keypointOf) {
      keyframe->sightings.push_back({point, keypoint});
      saved.p_map_m.emplace(point, graph.points().at(point).point.p_map_m);
    }
    saved.keyframes.push_back(std::move(keyframe));
  }
  saved.map = pieces.map().value_or(0);
  return saved;
}

}  // namespace wardslam::graph
