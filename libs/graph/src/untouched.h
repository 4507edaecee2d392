#pragma once

#include <set>

#include "wardslam/graph/keyframe_graph.h"

namespace wardslam::graph {

/// Keyframes of earlier runs that share no point with one of this run: nothing new is known about where they are.
[[nodiscard]] std::set<KeyframeId> untouched(const KeyframeGraph& graph);

}  // namespace wardslam::graph
