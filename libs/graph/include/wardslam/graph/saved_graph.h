#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "wardslam/graph/keyframe_graph.h"
#include "wardslam/graph/loop_verification.h"

namespace wardslam::graph {

/// The keyframes of an earlier run, to be recognised and gone on with.
struct SavedGraph {
  /// By id; `submap` is the piece each belongs to, in whose frame its pose is.
  std::vector<std::shared_ptr<const odometry::Keyframe>> keyframes;
  std::map<PointId, Eigen::Vector3d> p_map_m;  ///< Of the points they see.
  std::vector<Loop> loops;                     ///< That tie them together: ends, pose, inliers.
  std::uint32_t map = 0;                       ///< The piece that is the map (odometry::Pieces).
  std::uint32_t freeSubmap = 1;                ///< No submap of that run or an earlier one has this number or a higher.
};

/// All of a graph, as it is worth keeping.
[[nodiscard]] SavedGraph save(const KeyframeGraph& graph);

}  // namespace wardslam::graph
