#include "loop_confirmation.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "reach.h"

namespace wardslam::graph {
namespace {

constexpr double kLeastDouble_m = 8.0;  // nearer to each other, rooms that look the same are rare,
constexpr double kLeastRow_m = 16.0;    // and of those the camera sees no more than a part, or it is one of a row
constexpr double kMostRoom_m = 8.0;     // and larger is hardly one that looks the same all over
constexpr std::size_t kMostUnsettled = 200;
constexpr double kDisagreementPerMetre = 0.03;  // the camera goes on between two looks, and drifts
constexpr double kOnePlace_m = 0.5;             // a look from afar is not exact, and what only looks the same
constexpr double kOnePlace_rad = 0.15;          // is farther off than this

/// Where the newer keyframe stands by the loop, in the older one's map frame.
Eigen::Isometry3d T_map_newer(const KeyframeGraph& graph, const Loop& loop) {
  return graph.keyframes().at(loop.older).T_map_cam * loop.T_older_newer;
}

std::uint32_t pieceOf(const KeyframeGraph& graph, KeyframeId id) { return graph.keyframes().at(id).submap; }

bool joins(const KeyframeGraph& graph, const Loop& loop) {
  return pieceOf(graph, loop.older) != pieceOf(graph, loop.newer);
}

bool areOfSamePieces(const KeyframeGraph& graph, const Loop& a, const Loop& b) {
  return pieceOf(graph, a.older) == pieceOf(graph, b.older) && pieceOf(graph, a.newer) == pieceOf(graph, b.newer);
}

/// As the camera was tracked from one newer keyframe to the other.
Eigen::Isometry3d wayBetween(const KeyframeGraph& graph, const Loop& a, const Loop& b) {
  return graph.keyframes().at(a.newer).T_map_cam.inverse() * graph.keyframes().at(b.newer).T_map_cam;
}

/// By how much the two differ in where the newer keyframe of the second stands, for looks between the same pieces.
Eigen::Isometry3d differenceOf(const KeyframeGraph& graph, const Loop& a, const Loop& b) {
  const Eigen::Isometry3d byLoops = T_map_newer(graph, a).inverse() * T_map_newer(graph, b);
  return wayBetween(graph, a, b).inverse() * byLoops;
}

bool areOfOnePlace(const KeyframeGraph& graph, const Loop& a, const Loop& b) {
  if (!areOfSamePieces(graph, a, b)) return false;
  const Eigen::Isometry3d difference = differenceOf(graph, a, b);
  return difference.translation().norm() < kOnePlace_m &&
         Eigen::AngleAxisd(difference.linear()).angle() < kOnePlace_rad;
}

std::pair<std::size_t, int> evidenceOf(const std::vector<Loop>& loops) {
  int inliers = 0;
  for (const Loop& loop : loops) inliers = std::max(inliers, loop.inliers);
  return {loops.size(), inliers};
}

}  // namespace

void rehang(Loop& loop, const odometry::RemovedKeyframe& removed) {
  if (loop.older == removed.id) {
    loop.older = removed.heir;
    loop.T_older_newer = removed.T_heir_cam * loop.T_older_newer;
  }
  if (loop.newer == removed.id) {
    loop.newer = removed.heir;
    loop.T_older_newer = loop.T_older_newer * removed.T_heir_cam.inverse();
  }
}

std::vector<KeyframeId> LoopConfirmation::expected(const KeyframeGraph& graph, KeyframeId newest) const {
  std::vector<KeyframeId> places;
  for (const Hypothesis& hypothesis : hypotheses_) {
    const Loop& last = hypothesis.back();
    const Eigen::Isometry3d T_last_newest =
        graph.keyframes().at(last.newer).T_map_cam.inverse() * graph.keyframes().at(newest).T_map_cam;
    const Eigen::Isometry3d T_map_newest = T_map_newer(graph, last) * T_last_newest;
    const std::uint32_t piece = pieceOf(graph, last.older);
    double least = std::numeric_limits<double>::max();
    KeyframeId nearest = last.older;
    for (const auto& [id, node] : graph.keyframes()) {
      if (id > last.older && id >= hypothesis.front().newer) break;  // what is being told apart from old places
      if (node.submap != piece) continue;
      const Eigen::Isometry3d T = T_map_newest.inverse() * node.T_map_cam;
      const double distance = T.translation().norm() + Eigen::AngleAxisd(T.linear()).angle();
      if (distance >= least) continue;
      least = distance;
      nearest = id;
    }
    places.push_back(nearest);
  }
  return places;
}

std::vector<Loop> LoopConfirmation::confirm(const KeyframeGraph& graph, KeyframeId newest,
                                            const std::vector<Loop>& seen) {
  for (const Loop& loop : seen) {
    const auto same = std::find_if(hypotheses_.begin(), hypotheses_.end(),
                                   [&](const Hypothesis& known) { return agree(graph, known.back(), loop); });
    if (same == hypotheses_.end()) {
      hypotheses_.push_back({loop});
    } else if (same->back().newer != loop.newer) {
      same->push_back(loop);
    } else if (same->back().inliers < loop.inliers) {
      same->back() = loop;  // the same, by another keyframe of the place
    }
  }
  forget(graph, newest);
  const auto confirmed = std::find_if(hypotheses_.begin(), hypotheses_.end(),
                                      [&](const Hypothesis& known) { return isConfirmed(graph, known); });
  if (confirmed == hypotheses_.end()) return {};
  auto loops = std::move(*confirmed);
  hypotheses_.erase(confirmed);
  forget(graph, std::numeric_limits<KeyframeId>::max());  // the others were measured in a map that changes now
  std::reverse(loops.begin(), loops.end());
  return loops;
}

/// What is not seen again, for now.
void LoopConfirmation::forget(const KeyframeGraph& graph, KeyframeId newest) {
  const auto goesOn = [&](const Hypothesis& known) {
    return known.back().newer + static_cast<KeyframeId>(options_.max_gap) >= newest;
  };
  const auto over = std::stable_partition(hypotheses_.begin(), hypotheses_.end(), goesOn);
  for (auto known = over; known != hypotheses_.end(); ++known) {
    if (joins(graph, known->back())) keepUnsettled(graph, std::move(*known));
  }
  hypotheses_.erase(over, hypotheses_.end());
}

/// Beside what said the same earlier on; the weakest goes when there are too many.
void LoopConfirmation::keepUnsettled(const KeyframeGraph& graph, Hypothesis hypothesis) {
  const auto same = std::find_if(unsettled_.begin(), unsettled_.end(), [&](const Hypothesis& known) {
    return agree(graph, known.back(), hypothesis.back());
  });
  if (same != unsettled_.end()) {
    same->insert(same->end(), hypothesis.begin(), hypothesis.end());
    return;
  }
  unsettled_.push_back(std::move(hypothesis));
  if (unsettled_.size() <= kMostUnsettled) return;
  const auto isWeaker = [](const auto& a, const auto& b) { return evidenceOf(a) < evidenceOf(b); };
  unsettled_.erase(std::min_element(unsettled_.begin(), unsettled_.end(), isWeaker));
}

std::vector<Loop> LoopConfirmation::settle(const KeyframeGraph& graph,
                                           const std::function<bool(const Loop&)>& isRefused) {
  forget(graph, std::numeric_limits<KeyframeId>::max());
  for (Hypothesis& known : unsettled_) {
    const auto saysNothing = [&](const Loop& loop) { return !joins(graph, loop) || isRefused(loop); };
    known.erase(std::remove_if(known.begin(), known.end(), saysNothing), known.end());
  }
  const auto isEmpty = [](const Hypothesis& known) { return known.empty(); };
  unsettled_.erase(std::remove_if(unsettled_.begin(), unsettled_.end(), isEmpty), unsettled_.end());
  std::stable_sort(unsettled_.begin(), unsettled_.end(),
                   [](const auto& a, const auto& b) { return evidenceOf(a) > evidenceOf(b); });
  const auto best = std::find_if(unsettled_.begin(), unsettled_.end(), [&](const Hypothesis& known) {
    return isWideEnough(graph, known) && !hasRival(graph, known);
  });
  if (best == unsettled_.end()) return {};
  auto loops = std::move(*best);
  unsettled_.erase(best);
  std::reverse(loops.begin(), loops.end());
  return loops;
}

void LoopConfirmation::apply(const odometry::RemovedKeyframe& removed) {
  for (auto* const hypotheses : {&hypotheses_, &unsettled_}) {
    for (Hypothesis& hypothesis : *hypotheses) {
      for (Loop& loop : hypothesis) rehang(loop, removed);
    }
  }
}

void LoopConfirmation::resume(std::vector<Hypothesis> hypotheses, std::vector<Hypothesis> unsettled) {
  hypotheses_ = std::move(hypotheses);
  unsettled_ = std::move(unsettled);
}

bool LoopConfirmation::agree(const KeyframeGraph& graph, const Loop& a, const Loop& b) const {
  if (!areOfSamePieces(graph, a, b)) return false;
  const Eigen::Isometry3d difference = differenceOf(graph, a, b);
  const double way_m = wayBetween(graph, a, b).translation().norm();
  return difference.translation().norm() < options_.max_disagreement_m + kDisagreementPerMetre * way_m &&
         Eigen::AngleAxisd(difference.linear()).angle() < options_.max_disagreement_rad;
}

/// One strong look makes a join where a loop would ask for a second look that bears it out.
bool LoopConfirmation::isConfirmed(const KeyframeGraph& graph, const Hypothesis& hypothesis) const {
  const bool isJoin = joins(graph, hypothesis.back());
  const auto enough = static_cast<std::size_t>(isJoin ? options_.keyframes_to_join : options_.keyframes);
  const bool isEnough = hypothesis.size() >= enough;
  const auto isStrongLook = [this](const Loop& loop) { return isStrong(loop); };
  if (!isEnough && !(isJoin && std::any_of(hypothesis.begin(), hypothesis.end(), isStrongLook))) return false;
  return isWideEnough(graph, hypothesis) && !hasRival(graph, hypothesis);
}

/// Where the camera may be in another room that looks the same, for all that is known of its way, a room is not enough.
bool LoopConfirmation::isWideEnough(const KeyframeGraph& graph, const Hypothesis& hypothesis) const {
  const Loop& last = hypothesis.back();
  if (!joins(graph, last)) return true;
  const double ambiguity_m = graph::ambiguity_m(graph, last, verification_).value_or(0.0);
  if (ambiguity_m <= kLeastDouble_m) return true;
  const auto isOfAllThereIs = [this](const Loop& loop) { return isAllOver(loop); };
  if (ambiguity_m <= kLeastRow_m && canBeDriven(graph, last, verification_) &&
      std::any_of(hypothesis.begin(), hypothesis.end(), isOfAllThereIs)) {
    return true;
  }
  const auto isFar = [&](const Loop& a, const Loop& b) {
    const Eigen::Vector3d way_m =
        graph.keyframes().at(a.newer).T_map_cam.translation() - graph.keyframes().at(b.newer).T_map_cam.translation();
    return way_m.norm() > kMostRoom_m;
  };
  return std::any_of(hypothesis.begin(), hypothesis.end(), [&](const Loop& a) {
    return std::any_of(hypothesis.begin(), hypothesis.end(), [&](const Loop& b) { return isFar(a, b); });
  });
}

bool LoopConfirmation::isStrong(const Loop& loop) const {
  return loop.inliers >= options_.strong_inliers && isAllOver(loop);
}

/// Not one thing that looks like another, but all that there is to see.
bool LoopConfirmation::isAllOver(const Loop& loop) const {
  return loop.spread >= options_.strong_spread && loop.depth.overlap() >= options_.strong_overlap &&
         loop.depth.contradiction() <= options_.strong_contradiction;
}

/// A rival with half as many witnesses says that this place looks like another: then only going on tells. Between
/// pieces no rival is ever too old. The same place, seen less exactly, is none.
bool LoopConfirmation::hasRival(const KeyframeGraph& graph, const Hypothesis& hypothesis) const {
  const auto isRival = [&](const Hypothesis& other) {
    return &other != &hypothesis && !other.empty() && 2 * other.size() >= hypothesis.size() &&
           !areOfOnePlace(graph, other.back(), hypothesis.back()) && !isBetter(graph, hypothesis, other);
  };
  const auto isRivalJoin = [&](const Hypothesis& other) {
    return isRival(other) && areOfSamePieces(graph, other.back(), hypothesis.back());
  };
  if (std::any_of(hypotheses_.begin(), hypotheses_.end(), isRival)) return true;
  return joins(graph, hypothesis.back()) && std::any_of(unsettled_.begin(), unsettled_.end(), isRivalJoin);
}

/// Where more speaks for one, and the camera can hardly have come to the other.
bool LoopConfirmation::isBetter(const KeyframeGraph& graph, const Hypothesis& one, const Hypothesis& other) const {
  return joins(graph, one.back()) && joins(graph, other.back()) && evidenceOf(one) > evidenceOf(other) &&
         canBeDriven(graph, one.back(), verification_) && !canBeDriven(graph, other.back(), verification_);
}

}  // namespace wardslam::graph
