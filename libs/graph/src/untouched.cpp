#include "untouched.h"

namespace wardslam::graph {

std::set<KeyframeId> untouched(const KeyframeGraph& graph) {
  std::set<KeyframeId> keyframes;
  for (const auto& [id, node] : graph.keyframes()) {
    if (node.isRestored) keyframes.insert(id);
  }
  if (keyframes.empty()) return keyframes;
  for (const auto& [id, node] : graph.keyframes()) {
    if (node.isRestored) continue;
    for (const auto& [point, keypoint] : node.keypointOf) {
      for (const KeyframeId other : graph.points().at(point).seenBy) keyframes.erase(other);
    }
  }
  return keyframes;
}

}  // namespace wardslam::graph
