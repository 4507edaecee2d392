#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "wardslam/graph/graph_options.h"
#include "wardslam/graph/keyframe_graph.h"
#include "wardslam/graph/loop_verification.h"
#include "wardslam/odometry/map_update.h"

namespace wardslam::graph {

/// The loop as it is when what hung on the removed keyframe hangs on its heir.
void rehang(Loop& loop, const odometry::RemovedKeyframe& removed);

/// Places that seem to be seen again, until several keyframes say the same and none of another place does: rooms that
/// look the same are the rule in a hospital. What would join two pieces, and is not confirmed, is remembered to the
/// end.
class LoopConfirmation {
 public:
  explicit LoopConfirmation(const LoopConfirmationOptions& options, const LoopVerificationOptions& verification = {})
      : options_(options), verification_(verification) {}

  /// Old keyframes nearest to where this one stands if what was seen before it is right.
  [[nodiscard]] std::vector<KeyframeId> expected(const KeyframeGraph& graph, KeyframeId newest) const;

  /// Takes in what the newest keyframe was seen to be. Returns the loops that say the same, the newest first, once
  /// they are as many as the options ask for; they are forgotten here.
  std::vector<Loop> confirm(const KeyframeGraph& graph, KeyframeId newest, const std::vector<Loop>& seen);

  /// When no more keyframes come: the loops that most speaks for of those that would join two pieces, as long as no
  /// others speak half as much for another place. They are forgotten here; nothing: there are none. Leaves out loops
  /// that `isRefused`.
  std::vector<Loop> settle(const KeyframeGraph& graph, const std::function<bool(const Loop&)>& isRefused);

  /// Much of the place was found, all over the image, and depth bears it out.
  [[nodiscard]] bool isStrong(const Loop& loop) const;

  void apply(const odometry::RemovedKeyframe& removed);

  /// Loops that agree with each other, in order of their newer keyframes.
  using Hypothesis = std::vector<Loop>;

  [[nodiscard]] const std::vector<Hypothesis>& hypotheses() const { return hypotheses_; }
  [[nodiscard]] const std::vector<Hypothesis>& unsettled() const { return unsettled_; }
  void resume(std::vector<Hypothesis> hypotheses, std::vector<Hypothesis> unsettled);

 private:
  [[nodiscard]] bool agree(const KeyframeGraph& graph, const Loop& a, const Loop& b) const;
  [[nodiscard]] bool isConfirmed(const KeyframeGraph& graph, const Hypothesis& hypothesis) const;
  [[nodiscard]] bool hasRival(const KeyframeGraph& graph, const Hypothesis& hypothesis) const;
  [[nodiscard]] bool isBetter(const KeyframeGraph& graph, const Hypothesis& one, const Hypothesis& other) const;
  void forget(const KeyframeGraph& graph, KeyframeId newest);
  void keepUnsettled(const KeyframeGraph& graph, Hypothesis hypothesis);

  [[nodiscard]] bool isAllOver(const Loop& loop) const;
  [[nodiscard]] bool isWideEnough(const KeyframeGraph& graph, const Hypothesis& hypothesis) const;

  LoopConfirmationOptions options_;
  LoopVerificationOptions verification_;
  std::vector<Hypothesis> hypotheses_;
  std::vector<Hypothesis> unsettled_;  ///< Not seen again, of two pieces when they were.
};

}  // namespace wardslam::graph
