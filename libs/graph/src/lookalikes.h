#pragma once

#include <functional>
#include <map>
#include <vector>

#include "wardslam/graph/keyframe_graph.h"
#include "wardslam/graph/loop_verification.h"
#include "wardslam/odometry/map_update.h"

namespace wardslam::graph {

/// Places known to have a double: something looked just as they do where they cannot be. What looks like two places may
/// look like a third, so such a place alone says little of where the camera is.
class Lookalikes {
 public:
  /// The loop's ends look the same and are so far apart; not finite: nobody knows how far. `newerPlace`: keyframes that
  /// see what its newer end does.
  void add(const Loop& loop, const std::vector<KeyframeId>& newerPlace, double apart_m);

  /// Whether a double may have been seen instead: always where two pieces would be joined by it, else if the loop asks
  /// for a correction that leads half the way to the nearest double, or farther.
  [[nodiscard]] bool areMistakable(const KeyframeGraph& graph, const Loop& loop) const;

  /// What a keyframe's room looks like elsewhere (doublesOf()); searched for once.
  const std::vector<Loop>& doublesOf(KeyframeId id, const std::function<std::vector<Loop>()>& search);

  void apply(const odometry::RemovedKeyframe& removed);

  [[nodiscard]] const std::map<KeyframeId, double>& apart_m() const { return apart_m_; }
  [[nodiscard]] const std::map<KeyframeId, std::vector<Loop>>& doubles() const { return doubles_; }
  void resume(std::map<KeyframeId, double> apart_m, std::map<KeyframeId, std::vector<Loop>> doubles);

 private:
  void add(KeyframeId id, double apart_m);

  std::map<KeyframeId, double> apart_m_;  ///< From the nearest double.
  std::map<KeyframeId, std::vector<Loop>> doubles_;
};

/// How far the loop says that its newer end is from where it is in the map; of one piece.
[[nodiscard]] double correction_m(const KeyframeGraph& graph, const Loop& loop);

}  // namespace wardslam::graph
