#pragma once

#include <vector>

#include "wardslam/graph/keyframe_graph.h"
#include "wardslam/graph/loop_verification.h"
#include "wardslam/graph/place_recognition.h"

namespace wardslam::graph {

/// Looks of a keyframe at places of its own piece that are too far from it to be what it sees, and look and measure the
/// same all the same. What is nearer is not asked.
[[nodiscard]] std::vector<Loop> doublesOf(const KeyframeGraph& graph, KeyframeId id, const PlaceRecognition& places,
                                          const LoopVerification& verification, const PlaceRecognitionOptions& options);

/// Keyframes of its piece from which one may see the room that a keyframe sees, itself among them; where they are many,
/// some of them, evenly.
[[nodiscard]] std::vector<KeyframeId> roomAround(const KeyframeGraph& graph, KeyframeId id);

/// Whether a join that says that its newer end is in a room may be of that room's double as well. `look`: one of
/// doublesOf() a keyframe of the room. It may not if the map has the double from there and it looks otherwise, or the
/// surfaces around do not fit.
[[nodiscard]] bool explains(const KeyframeGraph& graph, const Loop& look, const Loop& join,
                            const LoopVerification& verification, const LoopVerificationOptions& options);

}  // namespace wardslam::graph
