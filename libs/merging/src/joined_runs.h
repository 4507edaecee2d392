#pragma once

#include <functional>
#include <map>
#include <vector>

#include "runs.h"
#include "wardslam/graph/mapper.h"
#include "work_file.h"

namespace wardslam::merging {

/// The graphs of several runs, one where places connect them.
struct JoinedRuns {
  graph::SavedGraph graph;                                      ///< Where all is in the end; `submap` is the piece.
  std::map<graph::KeyframeId, Eigen::Isometry3d> T_joined_cam;  ///< Of the keyframes of the graph.
  odometry::Pieces pieces;                                      ///< Which pieces of the runs are one by now.
  std::vector<odometry::SubmapJoin> joins;                      ///< In their order.
  std::vector<graph::Loop> looksBetweenRuns;  ///< As measured: how a keyframe of one stood, seen from one of another.
  std::uint32_t map = 0;                      ///< The largest piece, by the number that the others were joined to.
};

/// Has every run look for places of those before it, and adjusts what that ties together. Pieces that nothing connects
/// stay as they are, to the last bit. `work` (may be null): where it goes on from, and where it is kept, now and then
/// and when `progress` throws.
[[nodiscard]] JoinedRuns joinRuns(const std::vector<Run>& runs, const pipeline::SlamOptions& options,
                                  const ProgressSink& progress, const WorkFile* work = nullptr);

/// How a piece of a run has moved around something in its frame: as the keyframe nearest to it has. `away_m`: from
/// there to a place in that frame.
[[nodiscard]] Eigen::Isometry3d motionAround(const std::function<double(const Eigen::Vector3d&)>& away_m,
                                             const Run& run, std::uint32_t piece, const JoinedRuns& joined);

}  // namespace wardslam::merging
