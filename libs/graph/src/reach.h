#pragma once

#include <optional>

#include "wardslam/graph/graph_options.h"
#include "wardslam/graph/keyframe_graph.h"
#include "wardslam/graph/loop_verification.h"

namespace wardslam::graph {

/// How far apart places can be at which the camera may be after it went unseen between the two pieces of a loop, given
/// the place that the loop says: it may have gone anywhere at the speed that it was seen to go with; but where the loop
/// has it on the way that it was going, places that far off the way need not be thought of. Over the passages from a
/// keyframe of one to the next one of the other, where it is least. Nothing: none is known, as one of the pieces is of
/// an earlier run.
[[nodiscard]] std::optional<double> ambiguity_m(const KeyframeGraph& graph, const Loop& loop,
                                                const LoopVerificationOptions& options);

/// Whether the camera, going as it went before and after, can have come to where the loop says with 1 m/s² at most:
/// else somebody carried it there, or it is elsewhere. True where nothing is known of before, as in earlier runs.
[[nodiscard]] bool canBeDriven(const KeyframeGraph& graph, const Loop& loop, const LoopVerificationOptions& options);

/// Whether the camera can have come from one piece to the other, as a loop between them says they lie, in the time that
/// it had: tracked stretches lead as far as they lead, no farther and no less far, and where it was lost it can have
/// gone on with some speed. Keyframes of an earlier run say nothing, as anything may have happened since.
[[nodiscard]] bool isWithinReach(const KeyframeGraph& graph, const Loop& loop, const LoopVerificationOptions& options);

}  // namespace wardslam::graph
