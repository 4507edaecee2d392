#pragma once

#include "wardslam/graph/graph_options.h"
#include "wardslam/graph/keyframe_graph.h"
#include "wardslam/graph/loop_verification.h"

namespace wardslam::graph {

/// How far the camera can have gone unseen between the two pieces of a loop: the sum over the gaps from a keyframe of
/// one to the next one of the other, where it is least, at the speed that it was seen to go with; 0: nothing is known
/// of it, as one of them is of an earlier run.
[[nodiscard]] double lostBetween_m(const KeyframeGraph& graph, const Loop& loop,
                                   const LoopVerificationOptions& options);

/// Whether the camera can have come from one piece to the other, as a loop between them says they lie, in the time that
/// it had: tracked stretches lead as far as they lead, no farther and no less far, and where it was lost it can have
/// gone on with some speed. Keyframes of an earlier run say nothing, as anything may have happened since.
[[nodiscard]] bool isWithinReach(const KeyframeGraph& graph, const Loop& loop, const LoopVerificationOptions& options);

}  // namespace wardslam::graph
