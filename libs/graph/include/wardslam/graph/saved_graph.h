#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <vector>

#include "wardslam/graph/keyframe_graph.h"
#include "wardslam/graph/loop_verification.h"

namespace wardslam::graph {

/// The keyframes of an earlier run, to be recognised and gone on with.
struct SavedGraph {
  std::vector<std::shared_ptr<const odometry::Keyframe>> keyframes;  ///< By id, all of submap 0, posed in the map.
  std::map<PointId, Eigen::Vector3d> p_map_m;                        ///< Of the points they see.
  std::vector<Loop> loops;                                           ///< That tie them together: ends, pose, inliers.
  std::uint32_t lastSubmap = 0;                                      ///< No submap of theirs had a higher number.
};

/// What is worth keeping of a graph: the submap of its first keyframe.
[[nodiscard]] SavedGraph save(const KeyframeGraph& graph);

}  // namespace wardslam::graph
