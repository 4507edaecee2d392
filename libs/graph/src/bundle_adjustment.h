#pragma once

#include <atomic>
#include <set>

#include "wardslam/graph/graph_options.h"
#include "wardslam/graph/keyframe_graph.h"
#include "wardslam/odometry/map_update.h"

namespace wardslam::graph {

/// Which part of the graph an adjustment moves. Keyframes that see points of `points` but are in neither set are left
/// out. Points that are held (KeyframeGraph::hold) hold still, whoever sees them; held keyframes are in neither set, as
/// all they see is held.
struct AdjustmentWindow {
  std::set<KeyframeId> moved;
  std::set<KeyframeId> fixed;
  std::set<PointId> points;
};

/// The newest keyframe's neighbourhood: it and the keyframes that share most points with it move, all their points
/// move, other keyframes that see these points hold still. The first keyframe moves only against what is held.
[[nodiscard]] AdjustmentWindow localWindow(const KeyframeGraph& graph, KeyframeId newest,
                                           const BundleAdjustmentOptions& options);

/// Everything in one submap. What is settled and sees what moves holds still, or else the first keyframe, where nothing
/// is held.
[[nodiscard]] AdjustmentWindow globalWindow(const KeyframeGraph& graph, std::uint32_t submap);

/// Least squares over all sightings in the window, reprojection and depth, and the floors its keyframes stand on
/// (FloorTies), with a robust loss; sightings that do not
/// fit afterwards are removed from the graph. Returns what changed. Stops early, with the best so far, once `stop`
/// (may be null) is set.
odometry::MapUpdate adjust(KeyframeGraph& graph, const AdjustmentWindow& window, const BundleAdjustmentOptions& options,
                           int maxIterations, const std::atomic<bool>* stop = nullptr);

}  // namespace wardslam::graph
