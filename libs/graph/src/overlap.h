#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "wardslam/graph/keyframe_graph.h"
#include "wardslam/odometry/depth_view.h"

namespace wardslam::graph {

/// What keyframes of two pieces say of the surfaces each other saw, if the pieces lie to each other as told: each of
/// `from` is compared with the one of `into` that then looks most from where it does.
[[nodiscard]] odometry::DepthAgreement depthAcross(const KeyframeGraph& graph, std::uint32_t from, std::uint32_t into,
                                                   const Eigen::Isometry3d& T_into_from);

}  // namespace wardslam::graph
