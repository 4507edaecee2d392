#include "wardslam/odometry/odometry.h"

#include <algorithm>
#include <deque>
#include <utility>

#include "constant_velocity.h"
#include "depth_anchor.h"
#include "keyframe_need.h"
#include "map_drift.h"
#include "pose_tracker.h"
#include "rolling_shutter.h"
#include "seen_points.h"
#include "wardslam/core/rigid_transform.h"

namespace wardslam::odometry {
namespace {

/// Keyframes a mapper may lag behind; where there is none, memory stays bounded.
constexpr std::size_t kMostAwaited = 256;

/// For so long a camera that was lost is believed to go on as it went.
constexpr double kGoesOn_s = 1.0;

std::vector<PointId> pointsOf(const Keyframe& keyframe) {
  std::vector<PointId> points;
  for (const Sighting& sighting : keyframe.sightings) points.push_back(sighting.point);
  return points;
}

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
  Tracker(const OdometryOptions& options, const Continuation& earlier)
      : options_(options),
        map_(options.local_map, earlier.lastPoint + 1),
        poseTracker_(options_),
        anchor_(options_.depth_alignment),
        shutter_(options_.rolling_shutter),
        pieces_(earlier.map),
        drift_(earlier.lastKeyframe) {
    lastKeyframe_.id = earlier.lastKeyframe;
    submap_ = earlier.submap;
  }

  [[nodiscard]] bool hasStarted() const { return hasStarted_; }

  void startFrom(const Eigen::Isometry3d& T_map_cam) {
    if (!hasStarted_) T_cam_map_ = T_map_cam.inverse();
  }

  OdometryResult track(double stamp_s, const core::CameraModel& camera, const core::Features& features,
                       const DepthImage& depth, const std::optional<MotionPrior>& motion, const Placement& placeAnew) {
    predict(motion);
    shutter_.begin(camera);
    map_.moveSome();
    TrackedImage view{stamp_s, camera, features, shutter_.rectified(features, camera), depth, frame_++, predicted_};
    anchor_.see(depth, camera);
    if (state_ == State::Initialising) return initialise(view, placeAnew);
    const Tracking tracking = find(view);
    const bool isFound = poseTracker_.isGood(tracking) || tracking.isHeldByDepth;
    return isFound ? accept(view, rectify(view, tracking)) : lose(view, tracking, placeAnew);
  }

  Eigen::Isometry3d apply(const std::shared_ptr<const MapUpdate>& update);

 private:
  struct LastKeyframe {
    KeyframeId id = 0;
    std::uint64_t frame = 0;
    Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
    std::size_t mostTracked = 0;  ///< Points found in one image since then.
  };

  /// One that an update may still have known as its newest.
  struct AwaitedKeyframe {
    KeyframeId id = 0;
    Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
    PointId nextPoint = 0;  ///< Points from here on are younger.
  };

  /// Of the last pose, where errors add up; a pose that points of the map tell begins anew.
  [[nodiscard]] PoseCovariance covarianceIfHeld() const {
    if (isHeld_) return covariance_;
    return PoseCovariance::Zero();
  }
  void predict(const std::optional<MotionPrior>& motion);
  OdometryResult initialise(const TrackedImage& view, const Placement& placeAnew);
  [[nodiscard]] core::SemanticDescriptor semanticDescriptorOf(const core::Features& features,
                                                              const core::Keypoint& keypoint) const;
  [[nodiscard]] bool goesOn(const TrackedImage& view) const;
  [[nodiscard]] PosePrior expected(const TrackedImage& view) const;
  [[nodiscard]] Tracking find(TrackedImage& view);
  [[nodiscard]] Tracking findNear(TrackedImage& view, const PosePrior& expected);
  [[nodiscard]] bool isWithinReach(const TrackedImage& view, const Tracking& tracking) const;
  [[nodiscard]] bool isCredible(const TrackedImage& view, const Tracking& tracking) const {
    return isWithinReach(view, tracking) && poseTracker_.isBorneOut(view, map_, tracking);
  }
  Tracking rectify(TrackedImage& view, const Tracking& tracking);
  OdometryResult accept(const TrackedImage& view, const Tracking& tracking);
  OdometryResult lose(const TrackedImage& view, const Tracking& tracking, const Placement& placeAnew);
  void beginSubmap();
  Eigen::Isometry3d correctionOfYounger(const MapUpdate& update);
  void moveWhatIsYounger(const Eigen::Isometry3d& correction);
  void updateMap(const TrackedImage& view, const Tracking& tracking);
  [[nodiscard]] SinceKeyframe sinceKeyframe(const TrackedImage& view) const;
  std::shared_ptr<const Keyframe> insertKeyframe(const TrackedImage& view, const Tracking& tracking,
                                                 const std::vector<std::size_t>& fresh);
  [[nodiscard]] OdometryResult result(const Tracking& tracking, std::shared_ptr<const Keyframe> keyframe) const;

  const OdometryOptions options_;
  LocalMap map_;
  PoseTracker poseTracker_;
  DepthAnchor anchor_;
  ConstantVelocity velocity_;
  RollingShutter shutter_;

  State state_ = State::Initialising;
  bool hasStarted_ = false;
  std::uint64_t frame_ = 0;
  double lastTracked_s_ = 0.0;
  Eigen::Isometry3d T_cam_map_ = Eigen::Isometry3d::Identity();
  PoseCovariance covariance_ = PoseCovariance::Zero();  ///< Of T_cam_map_, in the camera's frame.
  bool isHeld_ = false;                                 ///< By depth alone, in the last image.
  std::vector<PointId> lastSeen_;                       ///< Points found in the last frame that showed enough.
  /// Where motion priors lead from the last tracked frame; nothing where one was missing.
  std::optional<PosePrior> predicted_;
  std::uint64_t framesSincePose_ = 0;
  LastKeyframe lastKeyframe_;
  std::deque<AwaitedKeyframe> awaited_;  ///< Of this submap, oldest first.
  std::uint32_t submap_ = 0;
  Pieces pieces_;
  MapDrift drift_;
  int framesLost_ = 0;
};

core::SemanticDescriptor Odometry::Tracker::semanticDescriptorOf(const core::Features& features,
                                                                 const core::Keypoint& keypoint) const {
  const bool isAsked = features.semanticDescriptors && options_.matcher.max_semantic_difference < 1.0;
  return isAsked ? features.semanticDescriptors->of(keypoint) : core::SemanticDescriptor{};
}

void Odometry::Tracker::predict(const std::optional<MotionPrior>& motion) {
  const bool isNext = framesSincePose_++ == 0;
  if (!motion || !hasStarted_ || (!isNext && !predicted_)) {
    predicted_.reset();
    return;
  }
  const PosePrior from = isNext ? PosePrior{T_cam_map_, covarianceIfHeld()} : *predicted_;
  const MotionPrior way = composed({Eigen::Isometry3d::Identity(), from.covariance}, *motion);
  predicted_ = PosePrior{core::rigid(way.T_previous_now.inverse() * from.T_cam_map), way.covariance};
}

OdometryResult Odometry::Tracker::initialise(const TrackedImage& view, const Placement& placeAnew) {
  const auto fresh = newPoints(options_, view, {});
  const bool showsPoints = static_cast<int>(fresh.size()) >= options_.min_initial_points;
  if (!showsPoints && !anchor_.wouldHold()) return {};
  if (view.prior) T_cam_map_ = view.prior->T_cam_map;
  if (hasStarted_ && placeAnew) T_cam_map_ = placeAnew(T_cam_map_.inverse()).inverse();
  state_ = State::Ok;
  hasStarted_ = true;
  framesSincePose_ = 0;
  lastTracked_s_ = view.stamp_s;
  velocity_.forget();
  covariance_ = PoseCovariance::Zero();  // of a piece of its own, which begins here
  isHeld_ = false;
  anchor_.remember(T_cam_map_.inverse(), covariance_);
  OdometryResult begun = result({}, insertKeyframe(view, {}, fresh));
  begun.covariance = covariance_;
  return begun;
}

/// Whether it is known where to look first.
bool Odometry::Tracker::goesOn(const TrackedImage& view) const {
  return state_ == State::Ok || view.prior || view.stamp_s - lastTracked_s_ <= kGoesOn_s;
}

PosePrior Odometry::Tracker::expected(const TrackedImage& view) const {
  if (view.prior) return *view.prior;
  const MotionPrior way =
      composed({Eigen::Isometry3d::Identity(), covariance_}, velocity_.predict(view.stamp_s - lastTracked_s_));
  return {core::rigid(way.T_previous_now.inverse() * T_cam_map_), way.covariance};
}

Tracking Odometry::Tracker::find(TrackedImage& view) {
  if (goesOn(view)) {
    const Tracking tracking = findNear(view, expected(view));
    if (tracking.isHeldByDepth) return tracking;
    if (poseTracker_.isGood(tracking) && (state_ == State::Ok || isCredible(view, tracking))) return tracking;
  }
  Tracking tracking = poseTracker_.relocalise(view, map_);
  if (!isWithinReach(view, tracking)) tracking.inliers.clear();
  return tracking;
}

/// By key points and surfaces, each as sure as it is; where key points are too few, by surfaces alone.
Tracking Odometry::Tracker::findNear(TrackedImage& view, const PosePrior& expected) {
  const Tracking byPoints = poseTracker_.track(view, map_, lastSeen_, expected.T_cam_map);
  const bool isGood = poseTracker_.isGood(byPoints);
  const bool areMany = static_cast<int>(byPoints.inliers.size()) >= options_.depth_alignment.below_inliers;
  const auto held = anchor_.hold(expected, isGood ? byPoints.T_cam_map : expected.T_cam_map,
                                 areMany ? AlignmentStart::IsNear : AlignmentStart::MayBeFar);
  if (!held) return byPoints;
  const auto others = std::exchange(view.prior, held->pose);
  if (areMany) return poseTracker_.trackAgain(view, map_, byPoints);
  Tracking byBoth = poseTracker_.trackBesideDepth(view, map_, lastSeen_, held->pose.T_cam_map);
  const bool isUnsure = addedSigma_m(covariance_, expected.covariance) > options_.depth_alignment.max_start_sigma_m;
  if (byBoth.isHeldByDepth && (isGood || isUnsure)) {  // points know better than a pose at which they are not found
    view.prior = others;
    return byPoints;
  }
  byBoth.isGuess = byBoth.inliers.empty() && !held->isComplete;
  return byBoth;
}

/// Who went farther begins a piece of its own, and the map asks for more before it believes that.
bool Odometry::Tracker::isWithinReach(const TrackedImage& view, const Tracking& tracking) const {
  const RelocalisationOptions& options = options_.relocalisation;
  const double way_m = (tracking.T_cam_map.inverse().translation() - T_cam_map_.inverse().translation()).norm();
  const double since_s = std::max(0.0, view.stamp_s - lastTracked_s_);
  return way_m <= std::min(options.max_way_m, options.margin_m + options.max_speed_mps * since_s);
}

/// How the camera moved in this image is known only now: the same once more with that.
Tracking Odometry::Tracker::rectify(TrackedImage& view, const Tracking& tracking) {
  const auto noteMotion = [&](const Tracking& found) {
    shutter_.moved(T_cam_map_ * found.T_cam_map.inverse(), view.stamp_s - lastTracked_s_);
  };
  if (state_ != State::Ok) {
    shutter_.forgetMotion();
    return tracking;
  }
  noteMotion(tracking);
  Tracking again = tracking;
  if (shutter_.readout_s() != 0.0) {
    view.features = shutter_.rectified(view.recorded, view.camera);
    again = poseTracker_.trackAgain(view, map_, tracking);
    noteMotion(again);
  }
  shutter_.learn(view.stamp_s, again.T_cam_map.inverse(), view.camera, seenPoints(view, again.inliers));
  return again;
}

OdometryResult Odometry::Tracker::accept(const TrackedImage& view, const Tracking& tracking) {
  const bool wasOk = state_ == State::Ok;
  covariance_ = poseTracker_.covariance(view, map_, tracking);
  if (wasOk) {
    velocity_.observe(tracking.T_cam_map * T_cam_map_.inverse(), view.stamp_s - lastTracked_s_, !tracking.isGuess);
  } else {
    velocity_.forget();
  }
  T_cam_map_ = tracking.T_cam_map;
  const bool isFoundAgain = !wasOk || (isHeld_ && !tracking.isHeldByDepth);
  isHeld_ = tracking.isHeldByDepth;
  if (isFoundAgain) anchor_.forget();  // where that stood was less sure
  anchor_.remember(T_cam_map_.inverse(), covarianceIfHeld());
  lastTracked_s_ = view.stamp_s;
  state_ = State::Ok;
  framesLost_ = 0;
  framesSincePose_ = 0;
  updateMap(view, tracking);

  lastKeyframe_.mostTracked = std::max(lastKeyframe_.mostTracked, tracking.inliers.size());
  const auto fresh = newPoints(options_, view, tracking);
  const bool isKeyframe = needsKeyframe(options_, tracking, fresh.size(), sinceKeyframe(view));
  OdometryResult accepted = result(tracking, isKeyframe ? insertKeyframe(view, tracking, fresh) : nullptr);
  accepted.covariance = covariance_;
  return accepted;
}

OdometryResult Odometry::Tracker::lose(const TrackedImage& view, const Tracking& tracking, const Placement& placeAnew) {
  state_ = State::Lost;
  shutter_.forgetMotion();
  if (++framesLost_ <= options_.max_lost_frames) {
    OdometryResult lost = result(tracking, nullptr);
    if (!goesOn(view)) return lost;
    const PosePrior led = expected(view);
    lost.T_map_cam = led.T_cam_map.inverse();
    lost.T_keyframe_cam = lastKeyframe_.T_map_cam.inverse() * lost.T_map_cam;
    lost.covariance = led.covariance;
    return lost;
  }
  beginSubmap();
  return initialise(view, placeAnew);
}

/// Goes on with a fresh map where the old one was lost: what is recorded from now on can be joined to it later.
void Odometry::Tracker::beginSubmap() {
  map_.clear();
  anchor_.forget();
  lastSeen_.clear();
  awaited_.clear();
  state_ = State::Initialising;
  framesLost_ = 0;
  ++submap_;
}

void Odometry::Tracker::updateMap(const TrackedImage& view, const Tracking& tracking) {
  if (tracking.isHeldByDepth) return;
  for (const PointId id : tracking.visible) map_.countVisible(id);
  const Eigen::Isometry3d T_map_cam = T_cam_map_.inverse();
  lastSeen_.clear();
  for (const Match& match : tracking.inliers) {
    map_.observe(match.point, view.features.keypoints[match.keypoint], view.camera, T_map_cam, view.frame);
    lastSeen_.push_back(match.point);
  }
}

SinceKeyframe Odometry::Tracker::sinceKeyframe(const TrackedImage& view) const {
  return {view.frame - lastKeyframe_.frame, lastKeyframe_.mostTracked,
          lastKeyframe_.T_map_cam.inverse() * T_cam_map_.inverse()};
}

std::shared_ptr<const Keyframe> Odometry::Tracker::insertKeyframe(const TrackedImage& view, const Tracking& tracking,
                                                                  const std::vector<std::size_t>& fresh) {
  const Eigen::Isometry3d T_map_cam = T_cam_map_.inverse();
  const bool isFirst = map_.points().empty();
  auto keyframe = std::make_shared<Keyframe>();
  for (const Match& match : tracking.inliers) {
    const auto& keypoint = view.features.keypoints[match.keypoint];
    map_.describe(match.point, keypoint, descriptorOf(view.features, match.keypoint), T_map_cam);
    map_.describe(match.point, semanticDescriptorOf(view.features, keypoint));
    keyframe->sightings.push_back({match.point, match.keypoint});
  }
  for (const std::size_t i : fresh) {
    MapPoint point = makeMapPoint(view.features.keypoints[i], descriptorOf(view.features, i), view.camera, T_map_cam);
    point.lastSeenFrame = view.frame;
    point.semanticDescriptor = semanticDescriptorOf(view.features, view.features.keypoints[i]);
    const PointId id = map_.add(point);
    lastSeen_.push_back(id);
    keyframe->sightings.push_back({id, i});
  }
  keyframe->id = lastKeyframe_.id + 1;
  keyframe->submap = submap_;
  keyframe->stamp_s = view.stamp_s;
  keyframe->camera = view.camera;
  keyframe->T_map_cam = T_map_cam;
  if (!isFirst) keyframe->T_previous_cam = lastKeyframe_.T_map_cam.inverse() * T_map_cam;
  keyframe->features = view.features;
  keyframe->features.semanticDescriptors.reset();  // it may hold on to whole images
  if (!view.depth.depth_m.empty()) keyframe->depth = std::make_shared<DepthView>(makeDepthView(view.depth));
  pieces_.add(keyframe->id, submap_);
  isFirst ? drift_.begin(keyframe->id) : drift_.add(keyframe->id, *keyframe->T_previous_cam, covariance_);
  map_.addKeyframe(keyframe->id, pointsOf(*keyframe));
  map_.cull();
  lastKeyframe_ = {keyframe->id, view.frame, T_map_cam, 0};
  awaited_.push_back({keyframe->id, T_map_cam, map_.nextId()});
  if (awaited_.size() > kMostAwaited) awaited_.pop_front();
  return keyframe;
}

OdometryResult Odometry::Tracker::result(const Tracking& tracking, std::shared_ptr<const Keyframe> keyframe) const {
  OdometryResult result;
  result.state = state_;
  result.T_map_cam = T_cam_map_.inverse();
  result.referenceKeyframe = lastKeyframe_.id;
  result.T_keyframe_cam = lastKeyframe_.T_map_cam.inverse() * result.T_map_cam;
  result.drift = drift_.at(result.T_keyframe_cam);
  result.matches = tracking.matches;
  result.inliers = static_cast<int>(tracking.inliers.size());
  result.isHeldByDepth = tracking.isHeldByDepth;
  result.keyframe = std::move(keyframe);
  result.readout_s = shutter_.readout_s();
  result.piece = pieces_.pieceOf(submap_);
  result.isInMap = pieces_.isMap(submap_);
  return result;
}

Eigen::Isometry3d Odometry::Tracker::apply(const std::shared_ptr<const MapUpdate>& update) {
  const bool isMoved = update->joined && update->joined->from == pieces_.pieceOf(submap_);
  pieces_.apply(*update);
  if (update->submap != submap_) return Eigen::Isometry3d::Identity();
  if (update->seenAgain) drift_.seeAgain(*update->seenAgain, isMoved);
  const Eigen::Isometry3d correction = correctionOfYounger(*update);
  map_.apply(update, frame_, correction.linear());
  for (PointId& id : lastSeen_) {
    if (const auto fused = update->fusedPoints.find(id); fused != update->fusedPoints.end()) id = fused->second;
  }
  moveWhatIsYounger(correction);
  return correction;
}

/// When the mapper is behind and has adjusted a few keyframes only, the camera and what is younger stay: they were
/// placed by points in sight, and follow these with the next image. How the mapper's newest keyframe moves is half that
/// image's own error; given to what is younger it would come back with the next keyframe's pose, and grow.
Eigen::Isometry3d Odometry::Tracker::correctionOfYounger(const MapUpdate& update) {
  while (!awaited_.empty() && awaited_.front().id < update.newestKeyframe) awaited_.pop_front();
  if (awaited_.empty() || awaited_.front().id != update.newestKeyframe) return Eigen::Isometry3d::Identity();
  const bool isBehind = awaited_.size() > 1;
  if (isBehind && !update.movesTheMap) return Eigen::Isometry3d::Identity();
  return correctionOf(update, awaited_.front().T_map_cam);
}

/// `awaited_` begins with the newest keyframe that the update knew.
void Odometry::Tracker::moveWhatIsYounger(const Eigen::Isometry3d& correction) {
  if (awaited_.empty()) return;
  map_.movePoints(awaited_.front().nextPoint, correction);
  for (AwaitedKeyframe& keyframe : awaited_) keyframe.T_map_cam = correction * keyframe.T_map_cam;
  lastKeyframe_.T_map_cam = awaited_.back().T_map_cam;
  T_cam_map_ = T_cam_map_ * correction.inverse();
  anchor_.move(correction);
  shutter_.move(correction);
  if (predicted_) predicted_->T_cam_map = predicted_->T_cam_map * correction.inverse();
}

Odometry::Odometry(const OdometryOptions& options, const Continuation& earlier)
    : tracker_(std::make_unique<Tracker>(options, earlier)) {}
Odometry::~Odometry() = default;
Odometry::Odometry(Odometry&&) noexcept = default;
Odometry& Odometry::operator=(Odometry&&) noexcept = default;

bool Odometry::hasStarted() const { return tracker_->hasStarted(); }

void Odometry::startFrom(const Eigen::Isometry3d& T_map_cam) { tracker_->startFrom(T_map_cam); }

OdometryResult Odometry::track(double stamp_s, const core::CameraModel& camera, const core::Features& staticFeatures,
                               const DepthImage& depth, const std::optional<MotionPrior>& motion,
                               const Placement& placeAnew) {
  return tracker_->track(stamp_s, camera, staticFeatures, depth, motion, placeAnew);
}

Eigen::Isometry3d Odometry::apply(const std::shared_ptr<const MapUpdate>& update) { return tracker_->apply(update); }

}  // namespace wardslam::odometry
