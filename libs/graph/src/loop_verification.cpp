#include "wardslam/graph/loop_verification.h"

#include <algorithm>
#include <set>

#include "reach.h"
#include "way_uncertainty.h"

namespace wardslam::graph {
namespace {

using odometry::Match;
using odometry::PointObservation;

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

/// A keyframe of the place, how many of its points were found and how many should be in sight.
struct Overlap {
  KeyframeId keyframe = 0;
  int found = 0;
  int inSight = 0;
};

/// The keyframe most of whose points were found.
Overlap largestOverlap(const KeyframeGraph& graph, const std::vector<KeyframeId>& place,
                       const std::set<PointId>& inSight, const std::set<PointId>& found) {
  Overlap largest;
  for (const KeyframeId id : place) {
    Overlap overlap{id, 0, 0};
    for (const auto& [point, keypoint] : graph.keyframes().at(id).keypointOf) {
      overlap.inSight += static_cast<int>(inSight.count(point));
      overlap.found += static_cast<int>(found.count(point));
    }
    if (overlap.found > largest.found) largest = overlap;
  }
  return largest;
}

/// Part of the image, of 4 x 4, in which there is one of the matches.
double spreadOf(const std::vector<Match>& matches, const odometry::Keyframe& keyframe) {
  constexpr int kParts = 4;
  std::set<std::pair<int, int>> parts;
  for (const Match& match : matches) {
    const cv::Point2f& px = keyframe.features.keypoints[match.keypoint].raw_px;
    parts.emplace(static_cast<int>(px.x) * kParts / keyframe.camera.width_px,
                  static_cast<int>(px.y) * kParts / keyframe.camera.height_px);
  }
  return static_cast<double>(parts.size()) / (kParts * kParts);
}

/// By all that both measured; of maps that older versions wrote points are known, and no more.
odometry::DepthAgreement depthAgreement(const KeyframeGraph& graph, const Loop& loop,
                                        const std::set<PointId>& inSight) {
  const odometry::Keyframe& older = *graph.keyframes().at(loop.older).keyframe;
  const odometry::Keyframe& newer = *graph.keyframes().at(loop.newer).keyframe;
  odometry::DepthAgreement agreement;
  if (!newer.depth) return agreement;
  if (older.depth) {
    agreement += compareDepth(*older.depth, older.camera, *newer.depth, newer.camera, loop.T_older_newer);
    agreement += compareDepth(*newer.depth, newer.camera, *older.depth, older.camera, loop.T_older_newer.inverse());
    return agreement;
  }
  const Eigen::Isometry3d T_newer_map =
      loop.T_older_newer.inverse() * graph.keyframes().at(loop.older).T_map_cam.inverse();
  for (const PointId id : inSight) {
    agreement.count(lookUp(*newer.depth, newer.camera, T_newer_map * graph.points().at(id).point.p_map_m));
  }
  return agreement;
}

/// What the newer keyframe holds for one point, and the place for another.
std::vector<std::pair<PointId, PointId>> samePoints(const KeyframeNode& newer, const std::vector<Match>& matches) {
  std::map<std::size_t, PointId> seenAt;
  for (const auto& [point, keypoint] : newer.keypointOf) seenAt[keypoint] = point;
  std::vector<std::pair<PointId, PointId>> same;
  for (const Match& match : matches) {
    const auto seen = seenAt.find(match.keypoint);
    if (seen != seenAt.end() && seen->second != match.point) same.emplace_back(seen->second, match.point);
  }
  return same;
}

}  // namespace

std::vector<KeyframeId> LoopVerification::placeAround(const KeyframeGraph& graph, KeyframeId keyframe) const {
  std::vector<KeyframeId> place{keyframe};
  for (const auto& [id, shared] : graph.covisible(keyframe)) {
    if (place.size() <= static_cast<std::size_t>(options_.neighbours)) place.push_back(id);
  }
  return place;
}

std::optional<Loop> LoopVerification::verify(const KeyframeGraph& graph, KeyframeId newer,
                                             const std::vector<KeyframeId>& place,
                                             const std::vector<Loop>& closed) const {
  auto loop = look(graph, newer, place);
  return loop && isPlausible(graph, *loop, closed) ? loop : std::nullopt;
}

std::optional<Loop> LoopVerification::look(const KeyframeGraph& graph, KeyframeId newer,
                                           const std::vector<KeyframeId>& place) const {
  const KeyframeNode& node = graph.keyframes().at(newer);
  const odometry::Keyframe& keyframe = *node.keyframe;
  const auto points = pointsOf(graph, place);

  std::vector<odometry::DescribedPoint> described;
  for (const PointId id : points) described.push_back({id, &graph.points().at(id).point.descriptor});
  const auto alike = matcher_.searchEverywhere(described, keyframe.features);
  const auto rough = solver_.solve(observationsOf(graph, alike, keyframe), keyframe.camera);
  if (rough.inliers < options_.min_recognised) return std::nullopt;

  std::vector<odometry::ProjectedPoint> projections;
  std::set<PointId> inSight;
  for (const PointId id : points) {
    const auto projected = project(id, graph.points().at(id).point, keyframe.camera, rough.T_cam_map);
    if (!projected) continue;
    projections.push_back(*projected);
    inSight.insert(id);
  }
  const odometry::KeypointGrid grid(keyframe.features.keypoints, keyframe.camera);
  const auto matches = matcher_.searchNear(projections, keyframe.features, grid, options_.search_radius_px);
  const auto pose = solver_.refine(observationsOf(graph, matches, keyframe), keyframe.camera, rough.T_cam_map);
  std::vector<Match> inliers;
  std::set<PointId> found;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (!pose.isInlier[i]) continue;
    inliers.push_back(matches[i]);
    found.insert(matches[i].point);
  }
  const Overlap overlap = largestOverlap(graph, place, inSight, found);
  if (pose.inliers < options_.min_inliers || overlap.found < options_.min_found_fraction * overlap.inSight)
    return std::nullopt;

  const Eigen::Isometry3d T_older_map = graph.keyframes().at(overlap.keyframe).T_map_cam.inverse();
  Loop loop{overlap.keyframe,          newer, T_older_map * pose.T_cam_map.inverse(), pose.inliers,
            samePoints(node, inliers), place};
  loop.spread = spreadOf(inliers, keyframe);
  loop.depth = depthAgreement(graph, loop, inSight);
  return loop.depth.contradiction() <= options_.max_contradiction ? std::optional(std::move(loop)) : std::nullopt;
}

bool LoopVerification::isPlausible(const KeyframeGraph& graph, const Loop& loop,
                                   const std::vector<Loop>& closed) const {
  const KeyframeNode& older = graph.keyframes().at(loop.older);
  const KeyframeNode& newer = graph.keyframes().at(loop.newer);
  if (older.submap != newer.submap) return isWithinReach(graph, loop, options_);
  const Eigen::Isometry3d T_map_newer = older.T_map_cam * loop.T_older_newer;
  const auto uncertainty = uncertaintyOfWay(graph, closed, loop.older, loop.newer, options_);
  const Eigen::Isometry3d correction = T_map_newer * newer.T_map_cam.inverse();
  return uncertainty && uncertainty->explains(T_map_newer.translation() - newer.T_map_cam.translation(),
                                              Eigen::AngleAxisd(correction.linear()).angle(), options_);
}

}  // namespace wardslam::graph
