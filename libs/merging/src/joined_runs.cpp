#include "joined_runs.h"

#include <algorithm>
#include <limits>

namespace wardslam::merging {
namespace {

/// By keyframe: the runs are one after the other.
std::size_t runOf(const std::vector<Run>& runs, graph::KeyframeId id) {
  const auto isBehind = [id](const Run& run) { return run.map.graph.keyframes.back()->id < id; };
  return static_cast<std::size_t>(std::find_if_not(runs.begin(), runs.end(), isBehind) - runs.begin());
}

std::size_t keyframesOf(const std::vector<Run>& runs) {
  std::size_t keyframes = 0;
  for (const Run& run : runs) keyframes += run.map.graph.keyframes.size();
  return keyframes;
}

/// Of two alike the older one.
std::uint32_t largestOf(const odometry::Pieces& pieces) {
  const auto& sizes = pieces.sizes();
  const auto isSmaller = [](const auto& a, const auto& b) { return a.second < b.second; };
  return std::max_element(sizes.begin(), sizes.end(), isSmaller)->first;
}

}  // namespace

JoinedRuns joinRuns(const std::vector<Run>& runs, const pipeline::SlamOptions& options, const ProgressSink& progress) {
  JoinedRuns joined;
  graph::Mapper mapper(options.graph, options.odometry);
  const std::size_t total = keyframesOf(runs);
  std::size_t done = runs.front().map.graph.keyframes.size();
  const auto onKeyframe = [&](const odometry::MapUpdate& update) {
    if (update.joined) joined.joins.push_back(*update.joined);
    progress({"keyframe", ++done, total});
  };
  mapper.restore(runs.front().map.graph);
  for (std::size_t i = 1; i < runs.size(); ++i) mapper.meet(runs[i].map.graph, onKeyframe);
  mapper.adjustAll();
  for (const graph::Loop& loop : mapper.loops()) {
    if (runOf(runs, loop.older) != runOf(runs, loop.newer)) joined.looksBetweenRuns.push_back(loop);
  }
  joined.graph = graph::save(mapper.graph());
  joined.graph.loops = mapper.loops();
  for (const auto& keyframe : joined.graph.keyframes) joined.T_joined_cam[keyframe->id] = keyframe->T_map_cam;
  joined.pieces = mapper.pieces();
  joined.map = largestOf(joined.pieces);
  return joined;
}

Eigen::Isometry3d motionAround(const std::function<double(const Eigen::Vector3d&)>& away_m, const Run& run,
                               std::uint32_t piece, const JoinedRuns& joined) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  double least_m = std::numeric_limits<double>::infinity();
  for (const auto& [id, keyframe] : run.map.semantic.keyframes) {
    const auto placed = joined.T_joined_cam.find(id);
    if (keyframe.piece != piece || placed == joined.T_joined_cam.end()) continue;
    const double here_m = away_m(keyframe.T_map_cam.translation());
    if (here_m >= least_m) continue;
    least_m = here_m;
    const bool isWhereItWas = placed->second.matrix() == keyframe.T_map_cam.matrix();
    motion = isWhereItWas ? Eigen::Isometry3d::Identity() : placed->second * keyframe.T_map_cam.inverse();
  }
  return motion;
}

}  // namespace wardslam::merging
