#include "wardslam/graph/saved_graph.h"

namespace wardslam::graph {

SavedGraph save(const KeyframeGraph& graph) {
  SavedGraph saved;
  for (const auto& [id, node] : graph.keyframes()) {
    if (node.submap != graph.keyframes().begin()->second.submap) continue;
    auto keyframe = std::make_shared<odometry::Keyframe>(*node.keyframe);
    keyframe->T_map_cam = node.T_map_cam;
    keyframe->submap = 0;
    keyframe->sightings.clear();
    for (const auto& [point, keypoint] : node.keypointOf) {
      keyframe->sightings.push_back({point, keypoint});
      saved.p_map_m.emplace(point, graph.points().at(point).point.p_map_m);
    }
    saved.keyframes.push_back(std::move(keyframe));
  }
  return saved;
}

}  // namespace wardslam::graph
