#include "wardslam/merging/alignment.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "joined_runs.h"
#include "rigid_fit.h"
#include "runs.h"

namespace wardslam::merging {
namespace {

using Poses = std::map<graph::KeyframeId, Eigen::Isometry3d>;

/// Of the map, not of pieces that are not joined to it.
Poses posesIn(const Run& run) {
  Poses T_map_cam;
  for (const auto& [id, keyframe] : run.map.semantic.keyframes) {
    if (keyframe.piece == run.map.semantic.piece) T_map_cam.emplace(id, keyframe.T_map_cam);
  }
  return T_map_cam;
}

/// What each look between the maps says, whichever of them is the older.
std::vector<PosePair> looksFrom(const Poses& a, const Poses& b, const std::vector<graph::Loop>& loops) {
  std::vector<PosePair> looks;
  for (const graph::Loop& loop : loops) {
    if (a.count(loop.older) != 0 && b.count(loop.newer) != 0)
      looks.push_back({a.at(loop.older) * loop.T_older_newer, b.at(loop.newer)});
    if (b.count(loop.older) != 0 && a.count(loop.newer) != 0)
      looks.push_back({a.at(loop.newer) * loop.T_older_newer.inverse(), b.at(loop.older)});
  }
  return looks;
}

}  // namespace

std::optional<Alignment> align(const std::filesystem::path& a, const std::filesystem::path& b,
                               const pipeline::SlamOptions& options, const ProgressSink& progress) {
  const std::vector<Run> runs = readRuns({a, b}, progress);
  Alignment alignment;
  alignment.haveOneFrame = shareKeyframes(runs[0], runs[1]);
  if (alignment.haveOneFrame) return alignment;
  const JoinedRuns joined = joinRuns(runs, options, progress);
  const Run& first = runs[0].file == a ? runs[0] : runs[1];
  const Run& second = runs[0].file == a ? runs[1] : runs[0];
  const auto looks = looksFrom(posesIn(first), posesIn(second), joined.looksBetweenRuns);
  if (looks.empty()) return std::nullopt;
  const RigidFit fit = fitRigidly(looks, options.graph.pose_graph);
  alignment.T_a_b = fit.T_a_b;
  alignment.covariance = fit.covariance;
  alignment.looks = looks.size();
  alignment.misfit_m = fit.misfit_m;
  alignment.misfit_rad = fit.misfit_rad;
  return alignment;
}

}  // namespace wardslam::merging
