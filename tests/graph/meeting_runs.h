#pragma once

#include <memory>
#include <vector>

#include "graph/mapper_walk.h"
#include "wardslam/graph/saved_graph.h"

namespace wardslam::graph {

/// Two runs in one synthetic world that know nothing of each other, as saved, each in the frame of its first keyframe:
/// `first` takes 16 steps on the circle; `second` 12 from 10 steps before the end of that, or, if they are to see
/// nothing in common, 8 from 6 steps behind it.
struct MeetingRuns {
  explicit MeetingRuns(bool meet) {
    first = savedRun(walk.walk(16));
    walk.loseTrack();
    for (int i = 0; i < (meet ? 10 : 0); ++i) walk.stepBack();
    for (int i = 0; i < (meet ? 0 : 6); ++i) walk.skip();
    second = savedRun(walk.walk(meet ? 12 : 8));
  }

  [[nodiscard]] static SavedGraph savedRun(const std::vector<std::shared_ptr<const odometry::Keyframe>>& keyframes) {
    GraphOptions options = fewAndFast();
    options.cull_keyframes = false;
    Mapper mapper(options, {});
    for (const auto& keyframe : keyframes) static_cast<void>(mapper.insert(keyframe));
    return save(mapper.graph());
  }

  test::SyntheticWalk walk{{0.5, 0.5, 10}, 1500};
  SavedGraph first;
  SavedGraph second;
};

}  // namespace wardslam::graph
