#pragma once

#include <mrpt/graphs/CNetworkOfPoses.h>

#include <set>
#include <utility>
#include <vector>

#include "floor_ties.h"
#include "wardslam/graph/graph_options.h"
#include "wardslam/graph/keyframe_graph.h"
#include "wardslam/graph/loop_verification.h"

namespace wardslam::graph {

/// Keyframes as nodes (T_map_cam), relative poses as edges. MRPT's type: saveToTextFile() and its programs know it.
using PoseGraph = mrpt::graphs::CNetworkOfPoses3DInf;

/// The keyframes of one submap, tied by what they share and by loops; held ones not among each other. Information is in
/// MRPT's order (x y z yaw pitch roll), in m and rad.
[[nodiscard]] PoseGraph makePoseGraph(const KeyframeGraph& graph, std::uint32_t submap, const std::vector<Loop>& loops,
                                      const PoseGraphOptions& options);

/// Moves all nodes but those of `held`, or else the root, so that the edges agree best. `loopEdges` are bent by a
/// robust kernel when they do not fit the rest, held nodes hold still, and what stands on one floor stays on it (all
/// Ceres only).
void optimise(PoseGraph& poses, const std::set<std::pair<KeyframeId, KeyframeId>>& loopEdges,
              const std::set<KeyframeId>& held, const PoseGraphOptions& options, const FloorTies& floors = {});

}  // namespace wardslam::graph
