#include "wardslam/graph/loop_verification.h"

#include <algorithm>
#include <set>

namespace wardslam::graph {
namespace {

using odometry::Match;
using odometry::PointObservation;

std::vector<KeyframeId> placeAround(const KeyframeGraph& graph, KeyframeId keyframe, int neighbours) {
  std::vector<KeyframeId> place{keyframe};
  for (const auto& [id, shared] : graph.covisible(keyframe)) {
    if (place.size() <= static_cast<std::size_t>(neighbours)) place.push_back(id);
  }
  return place;
}

std::set<PointId> pointsOf(const KeyframeGraph& graph, const std::vector<KeyframeId>& place) {
  std::set<PointId> points;
  for (const KeyframeId id : place) {
    for (const auto& [point, keypoint] : graph.keyframes().at(id).keypointOf) points.insert(point);
  }
  return points;
}

std::vector<PointObservation> observationsOf(const KeyframeGraph& graph, const std::vector<Match>& matches,
                                             const odometry::Keyframe& keyframe) {
  std::vector<PointObservation> observations;
  for (const Match& match : matches) {
    const auto& keypoint = keyframe.features.keypoints[match.keypoint];
    observations.push_back({graph.points().at(match.point).point.p_map_m, keypoint});
  }
  return observations;
}

/// Length of the camera's path between two keyframes, along the keyframes between as far as they share a frame.
double pathLength_m(const KeyframeGraph& graph, KeyframeId from, KeyframeId to) {
  double length_m = 0.0;
  const auto& keyframes = graph.keyframes();
  for (auto it = keyframes.find(from); it->first != to; ++it) {
    const KeyframeNode& here = it->second;
    const KeyframeNode& next = std::next(it)->second;
    if (here.submap != next.submap) continue;
    length_m += (next.T_map_cam.translation() - here.T_map_cam.translation()).norm();
  }
  return length_m;
}

}  // namespace

std::optional<Loop> LoopVerification::verify(const KeyframeGraph& graph, KeyframeId newer, KeyframeId older) const {
  const odometry::Keyframe& keyframe = *graph.keyframes().at(newer).keyframe;
  Loop loop{older, newer, {}, 0, {}, placeAround(graph, older, options_.neighbours)};
  const auto points = pointsOf(graph, loop.place);

  std::vector<odometry::DescribedPoint> described;
  for (const PointId id : points) described.push_back({id, &graph.points().at(id).point.descriptor});
  const auto alike = matcher_.searchEverywhere(described, keyframe.features);
  const auto rough = solver_.solve(observationsOf(graph, alike, keyframe), keyframe.camera);
  if (rough.inliers < options_.min_recognised) return std::nullopt;

  std::vector<odometry::ProjectedPoint> projections;
  for (const PointId id : points) {
    const auto projected = project(id, graph.points().at(id).point, keyframe.camera, rough.T_cam_map);
    if (projected) projections.push_back(*projected);
  }
  const odometry::KeypointGrid grid(keyframe.features.keypoints, keyframe.camera);
  const auto found = matcher_.searchNear(projections, keyframe.features, grid, options_.search_radius_px);
  const auto pose = solver_.refine(observationsOf(graph, found, keyframe), keyframe.camera, rough.T_cam_map);
  const double foundFraction = pose.inliers / std::max(1.0, static_cast<double>(projections.size()));
  if (pose.inliers < options_.min_inliers || foundFraction < options_.min_found_fraction) return std::nullopt;

  loop.inliers = pose.inliers;
  loop.T_older_newer = graph.keyframes().at(older).T_map_cam.inverse() * pose.T_cam_map.inverse();
  if (!isPlausible(graph, loop)) return std::nullopt;

  std::map<std::size_t, PointId> seenAt;
  for (const auto& [point, keypoint] : graph.keyframes().at(newer).keypointOf) seenAt[keypoint] = point;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto seen = seenAt.find(found[i].keypoint);
    if (!pose.isInlier[i] || seen == seenAt.end() || seen->second == found[i].point) continue;
    loop.samePoints.emplace_back(seen->second, found[i].point);
  }
  return loop;
}

bool LoopVerification::isPlausible(const KeyframeGraph& graph, const Loop& loop) const {
  const KeyframeNode& older = graph.keyframes().at(loop.older);
  const KeyframeNode& newer = graph.keyframes().at(loop.newer);
  if (older.submap != newer.submap) return true;  // nothing is known of how far apart they are
  const Eigen::Isometry3d T_map_newer = older.T_map_cam * loop.T_older_newer;
  const double correction_m = (T_map_newer.translation() - newer.T_map_cam.translation()).norm();
  const double believable_m = options_.max_drift_fraction * pathLength_m(graph, loop.older, loop.newer);
  return correction_m < std::max(options_.min_drift_m, believable_m);
}

}  // namespace wardslam::graph
