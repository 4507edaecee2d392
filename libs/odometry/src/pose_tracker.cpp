#include "pose_tracker.h"

#include <algorithm>

namespace wardslam::odometry {
namespace {

constexpr int kFewBesideDepth = 8;  // points that have a say where surfaces hold the rest
constexpr double kElsewhere_m = 0.5;
constexpr double kElsewhere_rad = 0.3;

const PosePrior* priorOf(const TrackedImage& view) { return view.prior ? &*view.prior : nullptr; }

/// Nothing it could rest on: for who counts matches.
Tracking refused(Tracking tracking) {
  tracking.inliers.clear();
  return tracking;
}

}  // namespace

Tracking PoseTracker::trackByMotion(const TrackedImage& view, const LocalMap& map, const std::vector<PointId>& lastSeen,
                                    const Eigen::Isometry3d& T_cam_map_predicted) const {
  Tracking tracking;
  for (const double widening : {1.0, 2.0, 4.0}) {
    tracking = search(view, map, lastSeen, T_cam_map_predicted, widening * options_.matcher.wide_radius_px);
    if (isGood(tracking)) return tracking;
  }
  // Who covers what the last image showed uncovers what others did.
  return search(view, map, map.neighbourhood(lastSeen), T_cam_map_predicted, options_.matcher.wide_radius_px);
}

Tracking PoseTracker::trackNeighbourhood(const TrackedImage& view, const LocalMap& map, const Tracking& rough) const {
  std::vector<PointId> seeds;
  for (const Match& match : rough.inliers) seeds.push_back(match.point);
  return search(view, map, map.neighbourhood(seeds), rough.T_cam_map, options_.matcher.narrow_radius_px);
}

Tracking PoseTracker::track(const TrackedImage& view, const LocalMap& map, const std::vector<PointId>& lastSeen,
                            const Eigen::Isometry3d& T_cam_map_predicted) const {
  const Tracking rough = trackByMotion(view, map, lastSeen, T_cam_map_predicted);
  return isGood(rough) ? trackNeighbourhood(view, map, rough) : rough;
}

Tracking PoseTracker::trackBesideDepth(const TrackedImage& view, const LocalMap& map,
                                       const std::vector<PointId>& lastSeen,
                                       const Eigen::Isometry3d& T_cam_map_held) const {
  Tracking rough = search(view, map, map.neighbourhood(lastSeen), T_cam_map_held, options_.matcher.wide_radius_px);
  if (isGood(rough)) return trackNeighbourhood(view, map, rough);
  rough.isHeldByDepth = true;
  if (static_cast<int>(rough.inliers.size()) < kFewBesideDepth) {
    rough.T_cam_map = T_cam_map_held;
    rough.inliers.clear();
  }
  return rough;
}

Tracking PoseTracker::trackAgain(const TrackedImage& view, const LocalMap& map, const Tracking& tracking) const {
  const Tracking again = estimate(view, map, tracking.inliers, tracking.T_cam_map);
  if (!isGood(again)) return tracking;
  Tracking result = tracking;
  result.T_cam_map = again.T_cam_map;
  result.inliers = again.inliers;
  return result;
}

Tracking PoseTracker::relocalise(const TrackedImage& view, const LocalMap& map) const {
  std::vector<DescribedPoint> points;
  for (const auto& [id, point] : map.points()) points.push_back({id, &point.descriptor});
  const auto matches = alike(view, map, matcher_.searchEverywhere(points, view.features));
  const Tracking byLooks = agreeing(view, map, matches);
  if (!isGood(byLooks) || hasRival(view, map, matches, byLooks)) return refused(byLooks);
  Tracking found = trackNeighbourhood(view, map, byLooks);
  return isGood(found) && isBorneOut(view, map, found) ? found : refused(found);
}

/// What most of the matches agree on, which are wrong for the most part: the others have no say.
Tracking PoseTracker::agreeing(const TrackedImage& view, const LocalMap& map, const std::vector<Match>& matches) const {
  const PoseEstimate pose = solver_.solve(observe(view, map, matches), view.camera);
  Tracking found{pose.T_cam_map, {}, {}, static_cast<int>(matches.size())};
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (pose.isInlier[i]) found.inliers.push_back(matches[i]);
  }
  return found;
}

/// Whether what does not fit this pose fits another one nearly as well.
bool PoseTracker::hasRival(const TrackedImage& view, const LocalMap& map, const std::vector<Match>& matches,
                           const Tracking& found) const {
  std::vector<bool> isInlier(view.features.size(), false);
  for (const Match& match : found.inliers) isInlier[match.keypoint] = true;
  std::vector<Match> others;
  for (const Match& match : matches) {
    if (!isInlier[match.keypoint]) others.push_back(match);
  }
  const PoseEstimate rival = solver_.solve(observe(view, map, others), view.camera);
  const auto enough = options_.relocalisation.max_rival * static_cast<double>(found.inliers.size());
  if (rival.inliers < options_.min_inliers || rival.inliers < enough) return false;
  const Eigen::Isometry3d T = rival.T_cam_map * found.T_cam_map.inverse();
  return T.translation().norm() > kElsewhere_m || Eigen::AngleAxisd(T.linear()).angle() > kElsewhere_rad;
}

bool PoseTracker::isBorneOut(const TrackedImage& view, const LocalMap& map, const Tracking& found) const {
  const RelocalisationOptions& options = options_.relocalisation;
  const std::size_t findable = std::min(found.visible.size(), view.features.size());
  if (static_cast<double>(found.inliers.size()) < options.min_found_fraction * static_cast<double>(findable)) {
    return false;
  }
  const DepthView depth = makeDepthView(view.depth);
  DepthAgreement agreement;
  for (const PointId id : found.visible) {
    agreement.count(lookUp(depth, view.camera, found.T_cam_map * map.find(id)->p_map_m));
  }
  return agreement.contradiction() <= options.max_contradiction;
}

Tracking PoseTracker::search(const TrackedImage& view, const LocalMap& map, const std::vector<PointId>& points,
                             const Eigen::Isometry3d& T_cam_map, double radius_px) const {
  std::vector<ProjectedPoint> projections;
  std::vector<PointId> visible;
  for (const PointId id : points) {
    const MapPoint* point = map.find(id);
    if (point == nullptr) continue;
    const auto projected = project(id, *point, view.camera, T_cam_map);
    if (!projected) continue;
    projections.push_back(*projected);
    if (maySee(view.depth, projected->raw_px, projected->depth_m, view.camera.depthNoise)) visible.push_back(id);
  }
  const auto matches = alike(view, map, matcher_.searchNear(projections, view.features, view.grid, radius_px));
  Tracking tracking = estimate(view, map, matches, T_cam_map);
  tracking.visible = std::move(visible);
  return tracking;
}

std::vector<Match> PoseTracker::alike(const TrackedImage& view, const LocalMap& map, std::vector<Match> matches) const {
  const double limit = options_.matcher.max_semantic_difference;
  if (!view.features.semanticDescriptors || limit >= 1.0) return matches;
  const auto differs = [&](const Match& match) {
    const core::SemanticDescriptor& known = map.find(match.point)->semanticDescriptor;
    if (known.empty()) return false;
    const core::SemanticDescriptor seen =
        view.features.semanticDescriptors->of(view.features.keypoints[match.keypoint]);
    return core::differenceOf(known, seen).value_or(0.0) > limit;
  };
  matches.erase(std::remove_if(matches.begin(), matches.end(), differs), matches.end());
  return matches;
}

Tracking PoseTracker::estimate(const TrackedImage& view, const LocalMap& map, const std::vector<Match>& matches,
                               const Eigen::Isometry3d& T_cam_map) const {
  const PoseEstimate pose = solver_.refine(observe(view, map, matches), view.camera, T_cam_map, priorOf(view));
  Tracking tracking{pose.T_cam_map, {}, {}, static_cast<int>(matches.size())};
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (pose.isInlier[i]) tracking.inliers.push_back(matches[i]);
  }
  return tracking;
}

PoseCovariance PoseTracker::covariance(const TrackedImage& view, const LocalMap& map, const Tracking& tracking) const {
  return solver_.covariance(observe(view, map, tracking.inliers), view.camera, tracking.T_cam_map, priorOf(view));
}

std::vector<PointObservation> PoseTracker::observe(const TrackedImage& view, const LocalMap& map,
                                                   const std::vector<Match>& matches) const {
  std::vector<PointObservation> observations;
  observations.reserve(matches.size());
  for (const Match& match : matches) {
    observations.push_back({map.find(match.point)->p_map_m, view.features.keypoints[match.keypoint]});
  }
  return observations;
}

}  // namespace wardslam::odometry
