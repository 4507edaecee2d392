#include "loop_confirmation.h"

#include <algorithm>
#include <limits>

namespace wardslam::graph {
namespace {

constexpr double kDisagreementPerMetre = 0.03;  // the camera goes on between two looks, and drifts

/// Where the newer keyframe stands by the loop, in the older one's map frame.
Eigen::Isometry3d T_map_newer(const KeyframeGraph& graph, const Loop& loop) {
  return graph.keyframes().at(loop.older).T_map_cam * loop.T_older_newer;
}

std::uint32_t pieceOf(const KeyframeGraph& graph, KeyframeId id) { return graph.keyframes().at(id).submap; }

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
  const auto isOver = [&](const Hypothesis& known) {
    return known.back().newer + static_cast<KeyframeId>(options_.max_gap) < newest;
  };
  hypotheses_.erase(std::remove_if(hypotheses_.begin(), hypotheses_.end(), isOver), hypotheses_.end());
  const auto confirmed = std::find_if(hypotheses_.begin(), hypotheses_.end(),
                                      [&](const Hypothesis& known) { return isConfirmed(graph, known); });
  if (confirmed == hypotheses_.end()) return {};
  auto loops = std::move(*confirmed);
  hypotheses_.clear();  // the others were measured in a map that changes now
  std::reverse(loops.begin(), loops.end());
  return loops;
}

void LoopConfirmation::apply(const odometry::RemovedKeyframe& removed) {
  for (Hypothesis& hypothesis : hypotheses_) {
    for (Loop& loop : hypothesis) rehang(loop, removed);
  }
}

bool LoopConfirmation::agree(const KeyframeGraph& graph, const Loop& a, const Loop& b) const {
  if (pieceOf(graph, a.older) != pieceOf(graph, b.older) || pieceOf(graph, a.newer) != pieceOf(graph, b.newer)) {
    return false;
  }
  const Eigen::Isometry3d byLoops = T_map_newer(graph, a).inverse() * T_map_newer(graph, b);
  const Eigen::Isometry3d byWay =
      graph.keyframes().at(a.newer).T_map_cam.inverse() * graph.keyframes().at(b.newer).T_map_cam;
  const Eigen::Isometry3d difference = byWay.inverse() * byLoops;
  return difference.translation().norm() <
             options_.max_disagreement_m + kDisagreementPerMetre * byWay.translation().norm() &&
         Eigen::AngleAxisd(difference.linear()).angle() < options_.max_disagreement_rad;
}

/// A rival with half as many witnesses says that this place looks like another: then only going on tells.
bool LoopConfirmation::isConfirmed(const KeyframeGraph& graph, const Hypothesis& hypothesis) const {
  const Loop& last = hypothesis.back();
  const bool joins = pieceOf(graph, last.older) != pieceOf(graph, last.newer);
  const auto enough = static_cast<std::size_t>(joins ? options_.keyframes_to_join : options_.keyframes);
  if (hypothesis.size() < enough) return false;
  return std::none_of(hypotheses_.begin(), hypotheses_.end(), [&](const Hypothesis& other) {
    return &other != &hypothesis && 2 * other.size() >= hypothesis.size();
  });
}

}  // namespace wardslam::graph
