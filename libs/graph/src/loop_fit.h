#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <vector>

#include "wardslam/graph/graph_options.h"
#include "wardslam/graph/keyframe_graph.h"
#include "wardslam/graph/loop_verification.h"

namespace wardslam::graph {

/// How keyframes stand, seen from the one before.
using Steps = std::map<KeyframeId, Eigen::Isometry3d>;

/// Of all keyframes of one piece that see the same as the one before, how one stands to the other.
[[nodiscard]] Steps tiedSteps(const KeyframeGraph& graph, std::uint32_t piece, int minSharedPoints);

/// Whether all loops, and the steps as they were before, still hold. A loop that is wrong stands against others, or
/// against what keyframes see in common: it must bend one of them.
[[nodiscard]] bool fit(const KeyframeGraph& graph, const Steps& stepsBefore, const std::vector<Loop>& loops,
                       const LoopConfirmationOptions& options);

}  // namespace wardslam::graph
