#include "reach.h"

#include <algorithm>
#include <optional>

namespace wardslam::graph {
namespace {

constexpr double kLeastSpeed_mps = 0.5;
constexpr double kFasterUnseen = 1.5;
constexpr double kLeastTime_s = 1.0;

/// How far the camera can be from a keyframe, and how far it must be, while later ones pass by. How a stretch that is
/// tracked without a gap lies to the one before nobody knows, but each is as long as it is.
class Reach {
 public:
  explicit Reach(const LoopVerificationOptions& options) : options_(options) {}

  void startFrom(const KeyframeNode& node) {
    first_ = last_ = &node;
    before_m_ = longestBefore_m_ = lost_m_ = lost_s_ = 0.0;
    gaps_ = 0;
  }

  void goOnTo(const KeyframeNode& node) {
    if (first_ == nullptr) return;
    if (node.submap != last_->submap || node.keyframe->submap != last_->keyframe->submap) {
      const double lostFor_s = std::max(0.0, node.keyframe->stamp_s - last_->keyframe->stamp_s);
      before_m_ += stretch_m();
      longestBefore_m_ = std::max(longestBefore_m_, stretch_m());
      lost_m_ += options_.lost_margin_m + options_.max_speed_mps * lostFor_s;
      lost_s_ += lostFor_s;
      ++gaps_;
      first_ = &node;
    }
    last_ = &node;
  }

  /// If it went unseen as fast as this.
  [[nodiscard]] double lost_m(double speed_mps) const { return gaps_ * options_.lost_margin_m + speed_mps * lost_s_; }
  [[nodiscard]] double most_m() const { return before_m_ + stretch_m() + lost_m_; }
  /// All the others may lead back along the longest stretch.
  [[nodiscard]] double least_m() const { return 2 * std::max(longestBefore_m_, stretch_m()) - most_m(); }

 private:
  [[nodiscard]] double stretch_m() const {
    return (last_->T_map_cam.translation() - first_->T_map_cam.translation()).norm();
  }

  const LoopVerificationOptions& options_;
  const KeyframeNode* first_ = nullptr;  ///< Of the stretch that is tracked without a gap.
  const KeyframeNode* last_ = nullptr;
  double before_m_ = 0.0;  ///< Sum over the stretches before.
  double longestBefore_m_ = 0.0;
  double lost_m_ = 0.0;
  double lost_s_ = 0.0;
  int gaps_ = 0;
};

/// The fastest that the camera was seen to go, and somewhat more; what carries it along goes no faster unseen. Over a
/// second at least: shorter steps tell of noise.
double usualSpeed_mps(const KeyframeGraph& graph, double most_mps) {
  const KeyframeNode* first = nullptr;
  double fastest_mps = kLeastSpeed_mps;
  for (const auto& [id, node] : graph.keyframes()) {
    if (node.isRestored) continue;
    if (first == nullptr || first->keyframe->submap != node.keyframe->submap) first = &node;
    const double since_s = node.keyframe->stamp_s - first->keyframe->stamp_s;
    if (since_s < kLeastTime_s) continue;
    const double way_m = (node.T_map_cam.translation() - first->T_map_cam.translation()).norm();
    fastest_mps = std::max(fastest_mps, kFasterUnseen * way_m / since_s);
    first = &node;
  }
  return std::min(fastest_mps, most_mps);
}

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
  const double speed_mps = usualSpeed_mps(graph, options.max_speed_mps);
  std::optional<double> least_m;
  forEachCrossing(graph, loop, options, [&](const KeyframeNode&, const KeyframeNode&, const Reach& reach) {
    least_m = std::min(least_m.value_or(reach.lost_m(speed_mps)), reach.lost_m(speed_mps));
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
    const double way_m = (position_m(to) - position_m(from)).norm();
    isWithin = isWithin && reach.least_m() <= way_m && way_m <= reach.most_m();
  });
  return isWithin;
}

}  // namespace wardslam::graph
