#pragma once

#include <Eigen/Geometry>
#include <map>
#include <vector>

#include "wardslam/graph/keyframe_graph.h"
#include "wardslam/graph/loop_verification.h"

namespace wardslam::graph {

/// Moves keyframes to new poses; every point goes with the first keyframe that saw it.
void moveKeyframes(KeyframeGraph& graph, const std::map<KeyframeId, Eigen::Isometry3d>& T_map_cam);

/// The keyframes of a piece, but for those that may not move, to where they fit each other and the loops best.
void optimisePoses(KeyframeGraph& graph, std::uint32_t piece, const std::vector<Loop>& loops,
                   const PoseGraphOptions& options);

}  // namespace wardslam::graph
