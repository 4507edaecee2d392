#include "loop_fit.h"

#include <algorithm>

namespace wardslam::graph {
namespace {

constexpr double kStill = 0.2;  // of what is allowed: by less, adjusting a map that is right moves it

bool exceeds(const Misfit& misfit, const LoopConfirmationOptions& options, double share = 1.0) {
  return misfit.position_m >= share * options.max_misfit_m || misfit.rotation_rad >= share * options.max_misfit_rad;
}

Eigen::Isometry3d step(const KeyframeGraph& graph, KeyframeId from, KeyframeId to) {
  return graph.keyframes().at(from).T_map_cam.inverse() * graph.keyframes().at(to).T_map_cam;
}

Misfit between(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  const Eigen::Isometry3d difference = a.inverse() * b;
  return {difference.translation().norm(), Eigen::AngleAxisd(difference.linear()).angle()};
}

Misfit operator-(const Misfit& a, const Misfit& b) {
  return {a.position_m - b.position_m, a.rotation_rad - b.rotation_rad};
}

}  // namespace

Steps tiedSteps(const KeyframeGraph& graph, std::uint32_t piece, int minSharedPoints) {
  Steps steps;
  for (const auto& [id, node] : graph.keyframes()) {
    const auto previous = graph.keyframes().find(id - 1);
    if (node.submap != piece || previous == graph.keyframes().end() || previous->second.submap != piece) continue;
    const auto isShared = [&](const auto& sighting) { return previous->second.keypointOf.count(sighting.first) != 0; };
    const auto shared = std::count_if(node.keypointOf.begin(), node.keypointOf.end(), isShared);
    if (shared >= minSharedPoints) steps.emplace(id, step(graph, id - 1, id));
  }
  return steps;
}

std::vector<Misfit> misfitsOf(const KeyframeGraph& graph, const std::vector<Loop>& loops) {
  std::vector<Misfit> misfits;
  for (const Loop& loop : loops) {
    const bool isOfOnePiece = graph.keyframes().at(loop.older).submap == graph.keyframes().at(loop.newer).submap;
    misfits.push_back(isOfOnePiece ? between(loop.T_older_newer, step(graph, loop.older, loop.newer)) : Misfit{});
  }
  return misfits;
}

bool fit(const KeyframeGraph& graph, const Held& before, const std::vector<Loop>& loops,
         const LoopConfirmationOptions& options) {
  for (const auto& [id, stepBefore] : before.steps) {
    if (exceeds(between(stepBefore, step(graph, id - 1, id)), options)) return false;
  }
  const auto misfits = misfitsOf(graph, loops);
  for (std::size_t i = 0; i < misfits.size(); ++i) {
    const Misfit grown = i < before.misfits.size() ? misfits[i] - before.misfits[i] : misfits[i];
    if (exceeds(misfits[i], options) && exceeds(grown, options, kStill)) return false;
  }
  return true;
}

}  // namespace wardslam::graph
