#include "map_motion.h"

#include <set>

#include "floor_ties.h"
#include "pose_graph.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/core/rigid_transform.h"

namespace wardslam::graph {

void moveKeyframes(KeyframeGraph& graph, const std::map<KeyframeId, Eigen::Isometry3d>& T_map_cam) {
  for (const auto& [id, node] : graph.points()) {
    const KeyframeId reference = *node.seenBy.begin();
    const auto moved = T_map_cam.find(reference);
    if (moved == T_map_cam.end()) continue;
    graph.movePoint(id, core::rigid(moved->second * graph.keyframes().at(reference).T_map_cam.inverse()));
  }
  for (const auto& [id, pose] : T_map_cam) graph.setPose(id, pose);
}

void optimisePoses(KeyframeGraph& graph, std::uint32_t piece, const std::vector<Loop>& loops,
                   const PoseGraphOptions& options) {
  PoseGraph poses = makePoseGraph(graph, piece, loops, options);
  std::set<std::pair<KeyframeId, KeyframeId>> loopEdges;
  for (const Loop& loop : loops) loopEdges.emplace(loop.older, loop.newer);
  std::set<KeyframeId> held;
  std::set<KeyframeId> nodes;
  for (const auto& [id, pose] : poses.nodes) {
    nodes.insert(id);
    if (!graph.keyframes().at(id).mayMove()) held.insert(id);
  }
  optimise(poses, loopEdges, held, options, FloorTies(graph, nodes));
  std::map<KeyframeId, Eigen::Isometry3d> T_map_cam;
  for (const auto& [id, pose] : poses.nodes) {
    if (held.count(id) == 0) T_map_cam[id] = core::fromMrpt(pose);
  }
  moveKeyframes(graph, T_map_cam);
}

}  // namespace wardslam::graph
