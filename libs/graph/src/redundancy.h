#pragma once

#include "wardslam/graph/graph_options.h"
#include "wardslam/graph/keyframe_graph.h"
#include "wardslam/odometry/map_update.h"

namespace wardslam::graph {

/// Whether this keyframe shows what was known from earlier visits: several old ones that see points it sees have nearly
/// all of them in sight, from as near and from the same side. As this asks for geometry and not for what was
/// recognised, a place holds only so many keyframes, however often one comes back.
[[nodiscard]] bool isRedundant(const KeyframeGraph& graph, KeyframeId id, const RedundancyOptions& options);

/// On which keyframe things can hang instead: the one that shares most points with it, and where it stays in its place,
/// of those that stay too, so that what is settled goes on to stay. There must be one.
[[nodiscard]] odometry::RemovedKeyframe heirOf(const KeyframeGraph& graph, KeyframeId id);

}  // namespace wardslam::graph
