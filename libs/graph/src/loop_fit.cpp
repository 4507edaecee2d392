#include "loop_fit.h"

#include <algorithm>

namespace wardslam::graph {
namespace {

bool isNear(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, const LoopConfirmationOptions& options) {
  const Eigen::Isometry3d difference = a.inverse() * b;
  return difference.translation().norm() < options.max_misfit_m &&
         Eigen::AngleAxisd(difference.linear()).angle() < options.max_misfit_rad;
}

}  // namespace

Steps tiedSteps(const KeyframeGraph& graph, std::uint32_t piece, int minSharedPoints) {
  Steps steps;
  for (const auto& [id, node] : graph.keyframes()) {
    const auto previous = graph.keyframes().find(id - 1);
    if (node.submap != piece || previous == graph.keyframes().end() || previous->second.submap != piece) continue;
    const auto isShared = [&](const auto& sighting) { return previous->second.keypointOf.count(sighting.first) != 0; };
    const auto shared = std::count_if(node.keypointOf.begin(), node.keypointOf.end(), isShared);
    if (shared >= minSharedPoints) steps.emplace(id, previous->second.T_map_cam.inverse() * node.T_map_cam);
  }
  return steps;
}

bool fit(const KeyframeGraph& graph, const Steps& stepsBefore, const std::vector<Loop>& loops,
         const LoopConfirmationOptions& options) {
  const auto& keyframes = graph.keyframes();
  const auto step = [&](KeyframeId from, KeyframeId to) -> Eigen::Isometry3d {
    return keyframes.at(from).T_map_cam.inverse() * keyframes.at(to).T_map_cam;
  };
  const auto isBent = [&](const auto& before) {
    return !isNear(before.second, step(before.first - 1, before.first), options);
  };
  const auto isMissed = [&](const Loop& loop) {
    const bool isOfOnePiece = keyframes.at(loop.older).submap == keyframes.at(loop.newer).submap;
    return isOfOnePiece && !isNear(loop.T_older_newer, step(loop.older, loop.newer), options);
  };
  return std::none_of(stepsBefore.begin(), stepsBefore.end(), isBent) &&
         std::none_of(loops.begin(), loops.end(), isMissed);
}

}  // namespace wardslam::graph
