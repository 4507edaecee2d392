#include "way_uncertainty.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <queue>

namespace wardslam::graph {
namespace {

constexpr double kMetresPerRadian = 1.0;  // turning in place drifts, too
constexpr std::size_t kTiedByPoints = 15;

using Steps = std::vector<std::pair<KeyframeId, double>>;

double lengthBetween_m(const KeyframeNode& a, const KeyframeNode& b, Drifting drifting) {
  if (drifting == Drifting::Unsettled && a.isSettled && b.isSettled) return 0.0;
  const Eigen::Isometry3d T_a_b = a.T_map_cam.inverse() * b.T_map_cam;
  return T_a_b.translation().norm() + kMetresPerRadian * Eigen::AngleAxisd(T_a_b.linear()).angle();
}

/// Where one can go from a keyframe, and how far it is.
Steps stepsFrom(const KeyframeGraph& graph, const std::multimap<KeyframeId, KeyframeId>& loopEnds, KeyframeId from,
                Drifting drifting) {
  const auto& keyframes = graph.keyframes();
  const auto here = keyframes.find(from);
  Steps steps;
  const auto add = [&](KeyframeId id, const KeyframeNode& node) {
    if (node.submap == here->second.submap) steps.emplace_back(id, lengthBetween_m(here->second, node, drifting));
  };
  if (here != keyframes.begin()) add(std::prev(here)->first, std::prev(here)->second);
  if (const auto next = std::next(here); next != keyframes.end()) add(next->first, next->second);
  for (const auto& [id, shared] : graph.covisible(from)) {
    if (shared < kTiedByPoints) break;
    add(id, keyframes.at(id));
  }
  const auto [begin, end] = loopEnds.equal_range(from);
  for (auto loop = begin; loop != end; ++loop) add(loop->second, keyframes.at(loop->second));
  return steps;
}

/// The shortest way, both ends included (Dijkstra); empty: none.
std::vector<KeyframeId> shortestWay(const KeyframeGraph& graph, const std::vector<Loop>& loops, KeyframeId from,
                                    KeyframeId to, Drifting drifting) {
  std::multimap<KeyframeId, KeyframeId> loopEnds;
  for (const Loop& loop : loops) {
    loopEnds.emplace(loop.older, loop.newer);
    loopEnds.emplace(loop.newer, loop.older);
  }
  struct Reached {
    double length_m;
    KeyframeId before;
    bool isFinal;
  };
  std::map<KeyframeId, Reached> reached{{from, {0.0, from, false}}};
  using Entry = std::pair<double, KeyframeId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  open.emplace(0.0, from);
  while (!open.empty()) {
    const KeyframeId here = open.top().second;
    open.pop();
    Reached& best = reached.at(here);
    if (best.isFinal) continue;
    best.isFinal = true;
    if (here == to) break;
    for (const auto& [next, step_m] : stepsFrom(graph, loopEnds, here, drifting)) {
      const Reached there{best.length_m + step_m, here, false};
      const auto [known, isNew] = reached.emplace(next, there);
      if (!isNew && (known->second.isFinal || known->second.length_m <= there.length_m)) continue;
      known->second = there;
      open.emplace(there.length_m, next);
    }
  }
  std::vector<KeyframeId> way;
  if (reached.count(to) == 0) return way;
  for (KeyframeId id = to; id != from; id = reached.at(id).before) way.push_back(id);
  way.push_back(from);
  return way;
}

}  // namespace

bool WayUncertainty::explains(const Eigen::Vector3d& position_m, double rotation_rad,
                              const LoopVerificationOptions& options) const {
  const double gate2 = options.gate_sigmas * options.gate_sigmas;
  const Eigen::Matrix3d floor_m2 = Eigen::Matrix3d::Identity() * (options.min_drift_m * options.min_drift_m / gate2);
  const double floor_rad2 = options.min_drift_rad * options.min_drift_rad / gate2;
  const double position2 = position_m.dot((position_m2 + floor_m2).ldlt().solve(position_m));
  const double rotation2 = rotation_rad * rotation_rad / (rotation_rad2 + floor_rad2);
  return position2 < gate2 && rotation2 < gate2;
}

std::optional<WayUncertainty> uncertaintyOfWay(const KeyframeGraph& graph, const std::vector<Loop>& loops,
                                               KeyframeId from, KeyframeId to, const LoopVerificationOptions& options,
                                               Drifting drifting) {
  const auto way = shortestWay(graph, loops, from, to, drifting);
  if (way.empty()) return std::nullopt;
  const auto& keyframes = graph.keyframes();
  const Eigen::Vector3d end_m = keyframes.at(to).T_map_cam.translation();
  WayUncertainty sum;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const KeyframeNode& here = keyframes.at(way[i]);
    const KeyframeNode& there = keyframes.at(way[i + 1]);
    const double length_m = lengthBetween_m(here, there, drifting);
    const double position_m2 = options.position_drift * options.position_drift * length_m;
    const double rotation_rad2 = options.rotation_drift_rad * options.rotation_drift_rad * length_m;
    const Eigen::Vector3d arm_m = end_m - there.T_map_cam.translation();
    const Eigen::Matrix3d across_m2 = arm_m.squaredNorm() * Eigen::Matrix3d::Identity() - arm_m * arm_m.transpose();
    sum.position_m2 += position_m2 * Eigen::Matrix3d::Identity() + rotation_rad2 * across_m2;
    sum.rotation_rad2 += rotation_rad2;
  }
  return sum;
}

}  // namespace wardslam::graph
