#include "lookalikes.h"

#include <algorithm>
#include <cmath>

#include "loop_confirmation.h"

namespace wardslam::graph {

double correction_m(const KeyframeGraph& graph, const Loop& loop) {
  const Eigen::Isometry3d T_map_newer = graph.keyframes().at(loop.older).T_map_cam * loop.T_older_newer;
  return (T_map_newer.translation() - graph.keyframes().at(loop.newer).T_map_cam.translation()).norm();
}

void Lookalikes::add(const Loop& loop, const std::vector<KeyframeId>& newerPlace, double apart_m) {
  add(loop.newer, apart_m);
  add(loop.older, apart_m);
  for (const KeyframeId id : newerPlace) add(id, apart_m);
  for (const KeyframeId id : loop.place) add(id, apart_m);
}

void Lookalikes::add(KeyframeId id, double apart_m) {
  const auto [known, isNew] = apart_m_.emplace(id, apart_m);
  if (!isNew) known->second = std::min(known->second, apart_m);
}

bool Lookalikes::areMistakable(const KeyframeGraph& graph, const Loop& loop) const {
  const bool joins = graph.keyframes().at(loop.older).submap != graph.keyframes().at(loop.newer).submap;
  const auto isMistakable = [&](KeyframeId end) {
    const auto known = apart_m_.find(end);
    if (known == apart_m_.end()) return false;
    return joins || (std::isfinite(known->second) && correction_m(graph, loop) > 0.5 * known->second);
  };
  return isMistakable(loop.older) || isMistakable(loop.newer);
}

const std::vector<Loop>& Lookalikes::doublesOf(KeyframeId id, const std::function<std::vector<Loop>()>& search) {
  const auto known = doubles_.find(id);
  return known != doubles_.end() ? known->second : doubles_.emplace(id, search()).first->second;
}

void Lookalikes::resume(std::map<KeyframeId, double> apart_m, std::map<KeyframeId, std::vector<Loop>> doubles) {
  apart_m_ = std::move(apart_m);
  doubles_ = std::move(doubles);
}

void Lookalikes::apply(const odometry::RemovedKeyframe& removed) {
  doubles_.erase(removed.id);
  for (auto& [id, looks] : doubles_) {
    for (Loop& look : looks) rehang(look, removed);
  }
  const auto known = apart_m_.find(removed.id);
  if (known == apart_m_.end()) return;
  add(removed.heir, known->second);
  apart_m_.erase(known);
}

}  // namespace wardslam::graph
