#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "wardslam/graph/graph_options.h"
#include "wardslam/graph/keyframe_graph.h"
#include "wardslam/graph/loop_verification.h"

namespace wardslam::graph {

/// Which keyframes may have drifted.
enum class Drifting : std::uint8_t {
  All,
  Unsettled,  ///< Those that are settled (KeyframeNode) stand to each other as they should: no step between two counts.
};

/// How well the map knows where one keyframe is, seen from another: one standard deviation squared, in the map's axes.
struct WayUncertainty {
  Eigen::Matrix3d position_m2 = Eigen::Matrix3d::Zero();
  double rotation_rad2 = 0.0;  ///< About each axis.

  /// Whether drift explains that the camera is off by so much. `position_m` in the map's axes.
  [[nodiscard]] bool explains(const Eigen::Vector3d& position_m, double rotation_rad,
                              const LoopVerificationOptions& options) const;
};

/// Along the shortest way through what ties keyframes together: points seen by both, the way from one to the next, and
/// loops. On each step position and direction drift at random, with its length; an error of direction grows with the
/// distance from where it was made. Nothing: no way leads from one to the other.
[[nodiscard]] std::optional<WayUncertainty> uncertaintyOfWay(const KeyframeGraph& graph, const std::vector<Loop>& loops,
                                                             KeyframeId from, KeyframeId to,
                                                             const LoopVerificationOptions& options,
                                                             Drifting drifting = Drifting::All);

}  // namespace wardslam::graph
