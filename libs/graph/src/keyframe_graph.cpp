#include "wardslam/graph/keyframe_graph.h"

#include <algorithm>

namespace wardslam::graph {

void KeyframeGraph::insert(const std::shared_ptr<const odometry::Keyframe>& keyframe) {
  KeyframeNode node{keyframe, keyframe->T_map_cam, {}};
  for (const odometry::Sighting& sighting : keyframe->sightings) {
    node.keypointOf.emplace(sighting.point, sighting.keypoint);
    PointNode& point = points_.try_emplace(sighting.point, PointNode{sighting.p_map_m, {}}).first->second;
    point.seenBy.insert(keyframe->id);
  }
  keyframes_.emplace(keyframe->id, std::move(node));
}

std::vector<std::pair<KeyframeId, std::size_t>> KeyframeGraph::covisible(KeyframeId id) const {
  std::map<KeyframeId, std::size_t> shared;
  for (const auto& [point, keypoint] : keyframes_.at(id).keypointOf) {
    for (const KeyframeId other : points_.at(point).seenBy) {
      if (other != id) ++shared[other];
    }
  }
  std::vector<std::pair<KeyframeId, std::size_t>> neighbours(shared.begin(), shared.end());
  std::stable_sort(neighbours.begin(), neighbours.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return neighbours;
}

void KeyframeGraph::removeSighting(KeyframeId keyframe, PointId point) {
  keyframes_.at(keyframe).keypointOf.erase(point);
  const auto node = points_.find(point);
  node->second.seenBy.erase(keyframe);
  if (node->second.seenBy.empty()) points_.erase(node);
}

void KeyframeGraph::removePoint(PointId point) {
  for (const KeyframeId id : points_.at(point).seenBy) keyframes_.at(id).keypointOf.erase(point);
  points_.erase(point);
}

}  // namespace wardslam::graph
