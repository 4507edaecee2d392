#include "wardslam/odometry/odometry.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "local_map.h"
#include "wardslam/odometry/keypoint_grid.h"
#include "wardslam/odometry/matcher.h"
#include "wardslam/odometry/pose_solver.h"

namespace wardslam::odometry {
namespace {

/// One image as the tracker sees it.
struct View {
  double stamp_s;
  const core::CameraModel& camera;
  const core::Features& features;
  KeypointGrid grid;
  std::uint64_t frame;
};

/// Matches of which some turned out to be inliers of a pose.
struct Tracking {
  Eigen::Isometry3d T_cam_map = Eigen::Isometry3d::Identity();
  std::vector<Match> inliers;
  int matches = 0;
};

}  // namespace

std::string toString(State state) {
  switch (state) {
    case State::Initialising:
      return "initialising";
    case State::Ok:
      return "ok";
    case State::Lost:
      return "lost";
  }
  return "unknown";
}

class Odometry::Tracker {
 public:
  explicit Tracker(const OdometryOptions& options)
      : options_(options), map_(options.local_map), matcher_(options.matcher), solver_(options.pose_solver) {}

  OdometryResult track(double stamp_s, const core::CameraModel& camera, const core::Features& features) {
    const View view{stamp_s, camera, features, KeypointGrid(features.keypoints, camera), frame_++};
    if (state_ == State::Initialising) return initialise(view);
    const Tracking tracking = find(view);
    return isGood(tracking) ? accept(view, tracking) : lose(tracking);
  }

  void apply(const MapUpdate& update);

 private:
  OdometryResult initialise(const View& view);
  [[nodiscard]] Tracking find(const View& view) const;
  [[nodiscard]] Tracking trackByMotion(const View& view) const;
  [[nodiscard]] Tracking trackLocalMap(const View& view, const Eigen::Isometry3d& T_cam_map) const;
  [[nodiscard]] Tracking relocalise(const View& view) const;
  [[nodiscard]] Tracking estimate(const View& view, const std::vector<Match>& matches,
                                  const Eigen::Isometry3d& T_cam_map) const;
  [[nodiscard]] std::vector<PointObservation> observe(const View& view, const std::vector<Match>& matches) const;
  [[nodiscard]] bool isGood(const Tracking& tracking) const {
    return static_cast<int>(tracking.inliers.size()) >= options_.min_inliers;
  }

  OdometryResult accept(const View& view, const Tracking& tracking);
  OdometryResult lose(const Tracking& tracking);
  void updateMap(const View& view, const Tracking& tracking);
  [[nodiscard]] std::vector<std::size_t> newPointCandidates(const View& view, const Tracking& tracking) const;
  [[nodiscard]] bool needsKeyframe(const View& view, const Tracking& tracking, std::size_t newPoints) const;
  std::shared_ptr<const Keyframe> insertKeyframe(const View& view, const Tracking& tracking,
                                                 const std::vector<std::size_t>& newPoints);

  OdometryOptions options_;
  LocalMap map_;
  Matcher matcher_;
  PoseSolver solver_;

  State state_ = State::Initialising;
  std::uint64_t frame_ = 0;
  Eigen::Isometry3d T_cam_map_ = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_cam_previous_ = Eigen::Isometry3d::Identity();  ///< Motion of the last frame.
  std::vector<PointId> lastSeen_;                                     ///< Points found in the last tracked frame.
  struct {
    KeyframeId id = 0;
    std::uint64_t frame = 0;
    Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
  } lastKeyframe_;
  std::size_t mostTracked_ = 0;  ///< Points found in one image since the last keyframe.
};

OdometryResult Odometry::Tracker::initialise(const View& view) {
  const auto newPoints = newPointCandidates(view, {});
  if (static_cast<int>(newPoints.size()) < options_.min_initial_points) return {};
  state_ = State::Ok;
  return {state_, T_cam_map_.inverse(), 0, static_cast<int>(newPoints.size()), insertKeyframe(view, {}, newPoints)};
}

Tracking Odometry::Tracker::find(const View& view) const {
  if (state_ == State::Ok) {
    const Tracking tracking = trackByMotion(view);
    if (isGood(tracking)) return trackLocalMap(view, tracking.T_cam_map);
  }
  const Tracking tracking = relocalise(view);
  return isGood(tracking) ? trackLocalMap(view, tracking.T_cam_map) : tracking;
}

Tracking Odometry::Tracker::trackByMotion(const View& view) const {
  const Eigen::Isometry3d T_cam_map_predicted = T_cam_previous_ * T_cam_map_;
  Tracking best;
  for (const double widening : {1.0, 2.0, 4.0}) {
    std::vector<ProjectedPoint> projections;
    for (const PointId id : lastSeen_) {
      if (map_.find(id) == nullptr) continue;
      if (const auto projected = map_.project(id, view.camera, T_cam_map_predicted)) projections.push_back(*projected);
    }
    const auto matches =
        matcher_.searchNear(projections, view.features, view.grid, widening * options_.matcher.wide_radius_px);
    best = estimate(view, matches, T_cam_map_predicted);
    if (isGood(best)) break;
  }
  return best;
}

Tracking Odometry::Tracker::trackLocalMap(const View& view, const Eigen::Isometry3d& T_cam_map) const {
  std::vector<ProjectedPoint> projections;
  for (const auto& [id, point] : map_.points()) {
    if (const auto projected = map_.project(id, view.camera, T_cam_map)) projections.push_back(*projected);
  }
  const auto matches = matcher_.searchNear(projections, view.features, view.grid, options_.matcher.narrow_radius_px);
  return estimate(view, matches, T_cam_map);
}

Tracking Odometry::Tracker::relocalise(const View& view) const {
  std::vector<DescribedPoint> points;
  for (const auto& [id, point] : map_.points()) points.push_back({id, &point.descriptor});
  const auto matches = matcher_.searchEverywhere(points, view.features);
  const PoseEstimate pose = solver_.solve(observe(view, matches), view.camera);
  return estimate(view, matches, pose.T_cam_map);
}

Tracking Odometry::Tracker::estimate(const View& view, const std::vector<Match>& matches,
                                     const Eigen::Isometry3d& T_cam_map) const {
  const PoseEstimate pose = solver_.refine(observe(view, matches), view.camera, T_cam_map);
  Tracking tracking{pose.T_cam_map, {}, static_cast<int>(matches.size())};
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (pose.isInlier[i]) tracking.inliers.push_back(matches[i]);
  }
  return tracking;
}

std::vector<PointObservation> Odometry::Tracker::observe(const View& view, const std::vector<Match>& matches) const {
  std::vector<PointObservation> observations;
  observations.reserve(matches.size());
  for (const Match& match : matches) {
    observations.push_back({map_.find(match.point)->p_map_m, view.features.keypoints[match.keypoint]});
  }
  return observations;
}

OdometryResult Odometry::Tracker::accept(const View& view, const Tracking& tracking) {
  const bool wasOk = state_ == State::Ok;
  T_cam_previous_ = wasOk ? tracking.T_cam_map * T_cam_map_.inverse() : Eigen::Isometry3d::Identity();
  T_cam_map_ = tracking.T_cam_map;
  state_ = State::Ok;
  updateMap(view, tracking);

  mostTracked_ = std::max(mostTracked_, tracking.inliers.size());
  const auto newPoints = newPointCandidates(view, tracking);
  OdometryResult result{state_, T_cam_map_.inverse(), tracking.matches, static_cast<int>(tracking.inliers.size()), {}};
  if (needsKeyframe(view, tracking, newPoints.size())) result.keyframe = insertKeyframe(view, tracking, newPoints);
  return result;
}

OdometryResult Odometry::Tracker::lose(const Tracking& tracking) {
  state_ = State::Lost;
  return {state_, T_cam_map_.inverse(), tracking.matches, static_cast<int>(tracking.inliers.size()), {}};
}

void Odometry::Tracker::updateMap(const View& view, const Tracking& tracking) {
  for (const auto& [id, point] : map_.points()) {
    if (map_.project(id, view.camera, T_cam_map_)) map_.countVisible(id);
  }
  const Eigen::Isometry3d T_map_cam = T_cam_map_.inverse();
  lastSeen_.clear();
  for (const Match& match : tracking.inliers) {
    map_.observe(match.point, view.features.keypoints[match.keypoint], view.camera, T_map_cam, view.frame);
    lastSeen_.push_back(match.point);
  }
}

std::vector<std::size_t> Odometry::Tracker::newPointCandidates(const View& view, const Tracking& tracking) const {
  std::vector<bool> isTaken(view.features.size(), false);
  for (const Match& match : tracking.inliers) isTaken[match.keypoint] = true;
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < view.features.size(); ++i) {
    const core::Keypoint& keypoint = view.features.keypoints[i];
    const bool isNear = keypoint.hasDepth() && static_cast<double>(keypoint.depth_m) <= options_.local_map.max_depth_m;
    if (isNear && !isTaken[i]) candidates.push_back(i);
  }
  return candidates;
}

bool Odometry::Tracker::needsKeyframe(const View& view, const Tracking& tracking, std::size_t newPoints) const {
  const KeyframeOptions& keyframes = options_.keyframes;
  if (static_cast<int>(newPoints) < keyframes.min_new_points) return false;
  const bool isLate = view.frame - lastKeyframe_.frame >= static_cast<std::uint64_t>(keyframes.max_frame_gap);
  const bool hasLeft =
      static_cast<double>(tracking.inliers.size()) < keyframes.min_tracked_fraction * static_cast<double>(mostTracked_);
  return isLate || hasLeft;
}

std::shared_ptr<const Keyframe> Odometry::Tracker::insertKeyframe(const View& view, const Tracking& tracking,
                                                                  const std::vector<std::size_t>& newPoints) {
  const Eigen::Isometry3d T_map_cam = T_cam_map_.inverse();
  auto keyframe = std::make_shared<Keyframe>();
  for (const Match& match : tracking.inliers) {
    map_.updateAppearance(match.point, view.features.keypoints[match.keypoint],
                          descriptorOf(view.features, match.keypoint), T_map_cam);
    keyframe->sightings.push_back({match.point, match.keypoint, map_.find(match.point)->p_map_m});
  }
  for (const std::size_t i : newPoints) {
    const PointId id =
        map_.add(view.features.keypoints[i], descriptorOf(view.features, i), view.camera, T_map_cam, view.frame);
    lastSeen_.push_back(id);
    keyframe->sightings.push_back({id, i, map_.find(id)->p_map_m});
  }
  keyframe->id = lastKeyframe_.id + 1;
  keyframe->stamp_s = view.stamp_s;
  keyframe->camera = view.camera;
  keyframe->T_map_cam = T_map_cam;
  keyframe->features = view.features;
  lastKeyframe_ = {keyframe->id, view.frame, T_map_cam};
  mostTracked_ = 0;
  map_.cull();
  return keyframe;
}

void Odometry::Tracker::apply(const MapUpdate& update) {
  map_.apply(update);
  const auto moved = update.T_map_cam.find(lastKeyframe_.id);
  if (moved == update.T_map_cam.end()) return;
  T_cam_map_ = T_cam_map_ * lastKeyframe_.T_map_cam * moved->second.inverse();
  lastKeyframe_.T_map_cam = moved->second;
}

Odometry::Odometry(const OdometryOptions& options) : tracker_(std::make_unique<Tracker>(options)) {}
Odometry::~Odometry() = default;
Odometry::Odometry(Odometry&&) noexcept = default;
Odometry& Odometry::operator=(Odometry&&) noexcept = default;

OdometryResult Odometry::track(double stamp_s, const core::CameraModel& camera, const core::Features& staticFeatures) {
  return tracker_->track(stamp_s, camera, staticFeatures);
}

void Odometry::apply(const MapUpdate& update) { tracker_->apply(update); }

}  // namespace wardslam::odometry
