#include "redundancy.h"

#include <algorithm>

namespace wardslam::graph {
namespace {

constexpr double kAsNear = 1.25;          // times the distance: a level of ORB's pyramid
constexpr double kSameDirection = 0.906;  // cosine of 25 degrees, within which ORB finds a point again

/// Whether a camera there sees the point as one here does: from as near, and from the same side.
bool seesAlike(const KeyframeNode& there, const KeyframeNode& here, const Eigen::Vector3d& p_map_m) {
  const Eigen::Vector3d p_there_m = there.T_map_cam.inverse() * p_map_m;
  if (!there.keyframe->camera.seenAt(p_there_m)) return false;
  const Eigen::Vector3d fromThere_m = p_map_m - there.T_map_cam.translation();
  const Eigen::Vector3d fromHere_m = p_map_m - here.T_map_cam.translation();
  const double product_m2 = fromThere_m.norm() * fromHere_m.norm();
  return fromThere_m.norm() < kAsNear * fromHere_m.norm() && fromThere_m.dot(fromHere_m) > kSameDirection * product_m2;
}

double shareSeenFrom(const KeyframeGraph& graph, const KeyframeNode& there, const KeyframeNode& here) {
  const auto isSeen = [&](const auto& sighting) {
    return seesAlike(there, here, graph.points().at(sighting.first).point.p_map_m);
  };
  const auto seen = std::count_if(here.keypointOf.begin(), here.keypointOf.end(), isSeen);
  return static_cast<double>(seen) / static_cast<double>(here.keypointOf.size());
}

}  // namespace

bool isRedundant(const KeyframeGraph& graph, KeyframeId id, const RedundancyOptions& options) {
  const KeyframeNode& node = graph.keyframes().at(id);
  int witnesses = 0;
  for (const auto& [other, shared] : graph.covisible(id)) {
    if (shared < static_cast<std::size_t>(options.min_shared_points)) break;
    if (other + static_cast<KeyframeId>(options.min_keyframe_gap) > id) continue;
    if (shareSeenFrom(graph, graph.keyframes().at(other), node) < options.min_share) continue;
    if (++witnesses == options.witnesses) return true;
  }
  return false;
}

odometry::RemovedKeyframe heirOf(const KeyframeGraph& graph, KeyframeId id) {
  const KeyframeNode& node = graph.keyframes().at(id);
  const auto covisible = graph.covisible(id);
  const auto staysLikeIt = [&](const auto& other) {
    return node.mayMove() || !graph.keyframes().at(other.first).mayMove();
  };
  auto heir = std::find_if(covisible.begin(), covisible.end(), staysLikeIt);
  if (heir == covisible.end()) heir = covisible.begin();
  return {id, heir->first, graph.keyframes().at(heir->first).T_map_cam.inverse() * node.T_map_cam};
}

}  // namespace wardslam::graph
