#include "reach.h"

#include <algorithm>
#include <optional>

namespace wardslam::graph {
namespace {

/// How far the camera can be from a keyframe, while later ones pass by.
class Reach {
 public:
  explicit Reach(const LoopVerificationOptions& options) : options_(options) {}

  void startFrom(const KeyframeNode& node) {
    first_ = last_ = &node;
    beforeStretch_m_ = lost_m_ = 0.0;
  }

  void goOnTo(const KeyframeNode& node) {
    if (first_ == nullptr) return;
    if (node.submap != last_->submap || node.keyframe->submap != last_->keyframe->submap) {
      const double lostFor_s = std::max(0.0, node.keyframe->stamp_s - last_->keyframe->stamp_s);
      const double gap_m = options_.lost_margin_m + options_.max_speed_mps * lostFor_s;
      beforeStretch_m_ = reach_m() + gap_m;
      lost_m_ += gap_m;
      first_ = &node;
    }
    last_ = &node;
  }

  [[nodiscard]] double lost_m() const { return lost_m_; }
  [[nodiscard]] double reach_m() const {
    return beforeStretch_m_ + (last_->T_map_cam.translation() - first_->T_map_cam.translation()).norm();
  }

 private:
  const LoopVerificationOptions& options_;
  const KeyframeNode* first_ = nullptr;  ///< Of the stretch that is tracked without a gap.
  const KeyframeNode* last_ = nullptr;
  double beforeStretch_m_ = 0.0;
  double lost_m_ = 0.0;
};

/// Calls for every keyframe of one of the loop's pieces that comes after one of the other, with the reach from there.
template <class Visit>
void forEachCrossing(const KeyframeGraph& graph, const Loop& loop, const LoopVerificationOptions& options,
                     const Visit& visit) {
  const std::uint32_t older = graph.keyframes().at(loop.older).submap;
  const std::uint32_t newer = graph.keyframes().at(loop.newer).submap;
  Reach reach(options);
  const KeyframeNode* before = nullptr;
  for (const auto& [id, node] : graph.keyframes()) {
    if (node.isRestored) continue;
    reach.goOnTo(node);
    if (node.submap != older && node.submap != newer) continue;
    if (before != nullptr && before->submap != node.submap) visit(*before, node, reach);
    before = &node;
    reach.startFrom(node);
  }
}

}  // namespace

double lostBetween_m(const KeyframeGraph& graph, const Loop& loop, const LoopVerificationOptions& options) {
  std::optional<double> least_m;
  forEachCrossing(graph, loop, options, [&](const KeyframeNode&, const KeyframeNode&, const Reach& reach) {
    least_m = std::min(least_m.value_or(reach.lost_m()), reach.lost_m());
  });
  return least_m.value_or(0.0);
}

bool isWithinReach(const KeyframeGraph& graph, const Loop& loop, const LoopVerificationOptions& options) {
  const KeyframeNode& older = graph.keyframes().at(loop.older);
  const KeyframeNode& newer = graph.keyframes().at(loop.newer);
  const Eigen::Isometry3d T_older_newer = older.T_map_cam * loop.T_older_newer * newer.T_map_cam.inverse();
  const auto position_m = [&](const KeyframeNode& node) -> Eigen::Vector3d {
    if (node.submap == newer.submap) return T_older_newer * node.T_map_cam.translation();
    return node.T_map_cam.translation();
  };
  bool isWithin = true;
  forEachCrossing(graph, loop, options, [&](const KeyframeNode& from, const KeyframeNode& to, const Reach& reach) {
    isWithin = isWithin && (position_m(to) - position_m(from)).norm() <= reach.reach_m();
  });
  return isWithin;
}

}  // namespace wardslam::graph
