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

/// How far the newer keyframe is from where a loop saw it.
struct Misfit {
  double position_m = 0.0;
  double rotation_rad = 0.0;
};

/// Of every loop; none of those between pieces, of which nothing is known yet.
[[nodiscard]] std::vector<Misfit> misfitsOf(const KeyframeGraph& graph, const std::vector<Loop>& loops);

/// What held before loops were closed.
struct Held {
  Steps steps;
  std::vector<Misfit> misfits;  ///< Of the loops closed by then.
};

/// Whether all of `loops`, those closed by then at the front, and the steps as they were before, still hold. A loop
/// that is wrong stands against others, or against what keyframes see in common: it must bend one of them. What a loop
/// was off by before tells nothing.
[[nodiscard]] bool fit(const KeyframeGraph& graph, const Held& before, const std::vector<Loop>& loops,
                       const LoopConfirmationOptions& options);

}  // namespace wardslam::graph
