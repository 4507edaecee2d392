#include "reach.h"

#include <algorithm>

namespace wardslam::graph {
namespace {

constexpr double kLeastSpeed_mps = 0.5;
constexpr double kFasterUnseen = 1.5;
constexpr double kLeastTime_s = 1.0;
constexpr double kMostAcceleration_mps2 = 1.0;

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
  /// Nothing where it was found again in between.
  [[nodiscard]] std::optional<double> lostInOneGo_s() const {
    return gaps_ == 1 ? std::optional(lost_s_) : std::nullopt;
  }
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

bool areOfOneStretch(const KeyframeNode& a, const KeyframeNode& b) {
  return a.submap == b.submap && a.keyframe->submap == b.keyframe->submap;
}

Eigen::Vector3d velocityBetween_mps(const KeyframeNode& from, const KeyframeNode& to) {
  return (to.T_map_cam.translation() - from.T_map_cam.translation()) / (to.keyframe->stamp_s - from.keyframe->stamp_s);
}

bool isLongEnough(const KeyframeNode& from, const KeyframeNode& to) {
  return to.keyframe->stamp_s - from.keyframe->stamp_s >= kLeastTime_s;
}

/// As the camera came to a keyframe; nothing where it was not tracked for long enough to tell.
std::optional<Eigen::Vector3d> velocityTo_mps(const KeyframeGraph& graph, const KeyframeNode& at) {
  for (auto before = graph.keyframes().find(at.keyframe->id); before != graph.keyframes().begin();) {
    const KeyframeNode& node = (--before)->second;
    if (!areOfOneStretch(node, at)) break;
    if (isLongEnough(node, at)) return velocityBetween_mps(node, at);
  }
  return std::nullopt;
}

/// As it went on from there.
std::optional<Eigen::Vector3d> velocityFrom_mps(const KeyframeGraph& graph, const KeyframeNode& at) {
  for (auto after = graph.keyframes().find(at.keyframe->id); after != graph.keyframes().end(); ++after) {
    if (!areOfOneStretch(after->second, at)) break;
    if (isLongEnough(at, after->second)) return velocityBetween_mps(at, after->second);
  }
  return std::nullopt;
}

/// From a keyframe of one of the loop's pieces to the next one of the other, in the older one's frame.
struct Crossing {
  Eigen::Vector3d way_m;                              ///< By the loop.
  std::optional<Eigen::Vector3d> velocityBefore_mps;  ///< Where that is known.
  std::optional<Eigen::Vector3d> velocityAfter_mps;   ///< Likewise.
  const Reach& reach;                                 ///< From there.
};

/// Calls for every keyframe of one of the loop's pieces that comes after one of the other.
template <class Visit>
void forEachCrossing(const KeyframeGraph& graph, const Loop& loop, const LoopVerificationOptions& options,
                     const Visit& visit) {
  const KeyframeNode& older = graph.keyframes().at(loop.older);
  const KeyframeNode& newer = graph.keyframes().at(loop.newer);
  const Eigen::Isometry3d T_older_newer = older.T_map_cam * loop.T_older_newer * newer.T_map_cam.inverse();
  const auto T_older = [&](const KeyframeNode& node) {
    return node.submap == newer.submap ? T_older_newer : Eigen::Isometry3d::Identity();
  };
  Reach reach(options);
  const KeyframeNode* before = nullptr;
  for (const auto& [id, node] : graph.keyframes()) {
    if (node.isRestored) continue;
    reach.goOnTo(node);
    if (node.submap != older.submap && node.submap != newer.submap) continue;
    if (before != nullptr && before->submap != node.submap) {
      const Eigen::Vector3d way_m =
          T_older(node) * node.T_map_cam.translation() - T_older(*before) * before->T_map_cam.translation();
      auto before_mps = velocityTo_mps(graph, *before);
      if (before_mps) before_mps = T_older(*before).linear() * *before_mps;
      auto after_mps = velocityFrom_mps(graph, node);
      if (after_mps) after_mps = T_older(node).linear() * *after_mps;
      visit(Crossing{way_m, before_mps, after_mps, reach});
    }
    before = &node;
    reach.startFrom(node);
  }
}

/// Who speeds up at most for half of the time, and slows down for the other half, comes a quarter of a t² off the way
/// that even acceleration leads.
bool canBeDriven(const Crossing& crossing, const LoopVerificationOptions& options) {
  const auto lost_s = crossing.reach.lostInOneGo_s();
  if (!lost_s || !crossing.velocityBefore_mps) return true;
  if (!crossing.velocityAfter_mps) return false;  // soon it is known
  const Eigen::Vector3d even_m = 0.5 * *lost_s * (*crossing.velocityBefore_mps + *crossing.velocityAfter_mps);
  const double off_m = 0.25 * kMostAcceleration_mps2 * *lost_s * *lost_s;
  return (crossing.way_m - even_m).norm() <= off_m + options.lost_margin_m;
}

/// Who goes on as before, or stops on the way, is near the straight way on; else it may be anywhere around.
double ambiguity_m(const Crossing& crossing, double speed_mps, const LoopVerificationOptions& options) {
  const double anywhere_m = 2 * crossing.reach.lost_m(speed_mps);
  const auto lost_s = crossing.reach.lostInOneGo_s();
  if (!lost_s) return anywhere_m;
  const Eigen::Vector3d halfWay_m = 0.5 * *lost_s * crossing.velocityBefore_mps.value_or(Eigen::Vector3d::Zero());
  const double radius_m = halfWay_m.norm() + options.lost_margin_m;
  const bool wentOn = (crossing.way_m - halfWay_m).norm() <= radius_m;
  return wentOn ? std::min(anywhere_m, 2 * radius_m) : anywhere_m;
}

}  // namespace

std::optional<double> ambiguity_m(const KeyframeGraph& graph, const Loop& loop,
                                  const LoopVerificationOptions& options) {
  const double speed_mps = usualSpeed_mps(graph, options.max_speed_mps);
  std::optional<double> least_m;
  forEachCrossing(graph, loop, options, [&](const Crossing& crossing) {
    const double here_m = ambiguity_m(crossing, speed_mps, options);
    least_m = std::min(least_m.value_or(here_m), here_m);
  });
  return least_m;
}

bool canBeDriven(const KeyframeGraph& graph, const Loop& loop, const LoopVerificationOptions& options) {
  bool isAny = false;
  bool isAnyDriven = false;
  forEachCrossing(graph, loop, options, [&](const Crossing& crossing) {
    isAny = true;
    isAnyDriven = isAnyDriven || canBeDriven(crossing, options);
  });
  return !isAny || isAnyDriven;
}

bool isWithinReach(const KeyframeGraph& graph, const Loop& loop, const LoopVerificationOptions& options) {
  bool isWithin = true;
  forEachCrossing(graph, loop, options, [&](const Crossing& crossing) {
    const double way_m = crossing.way_m.norm();
    isWithin = isWithin && crossing.reach.least_m() <= way_m && way_m <= crossing.reach.most_m();
  });
  return isWithin;
}

}  // namespace wardslam::graph
