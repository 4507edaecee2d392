#include "session.h"

#include <algorithm>
#include <iterator>
#include <memory>

#include "metric_maps.h"
#include "pose_pdf.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/exchange/simple_map.h"
#include "wardslam/sources/external_images.h"
#include "wardslam/sources/input_damage.h"

namespace wardslam::mrpt_slam {
namespace {

using mrpt::obs::CObservation3DRangeScan;

/// Observations of the rest do not pile up where no image comes.
constexpr std::size_t kMostWaiting = 1000;

pipeline::SlamOptions slamOptions(const MapBuilderConfiguration& configuration, bool updatesTheMap,
                                  const std::optional<Eigen::Isometry3d>& T_map_base) {
  pipeline::SlamOptions options = configuration.slam;
  if (!updatesTheMap) options.mapping.enabled = false;
  if (T_map_base) options.map_frame.T_map_base = T_map_base;
  return options;
}

pipeline::WhenBehind whenBehind(const MapBuilderOptions& options) {
  return options.waits_for_map ? pipeline::WhenBehind::Waits : pipeline::WhenBehind::LeavesViewsOut;
}

/// As far off as the robot can have gone by now, and turned anywhere.
odometry::PoseCovariance goneSince(double lost_s, const odometry::RelocalisationOptions& options) {
  constexpr double kAnyTurn_rad = 1.0;
  const double way_m = options.margin_m + options.max_speed_mps * std::max(0.0, lost_s);
  odometry::PoseCovariance covariance = odometry::PoseCovariance::Zero();
  covariance.diagonal().head<3>().setConstant(way_m * way_m);
  covariance.diagonal().tail<3>().setConstant(kAnyTurn_rad * kAnyTurn_rad);
  return covariance;
}

/// Reads the images where they lie in files.
void requireUsable(const CObservation3DRangeScan& image, const std::optional<double>& last_s) {
  const double stamp_s = core::fromMrptTime(image.timestamp);
  if (last_s && stamp_s < *last_s) {
    throw core::FrameError("an observation was taken " + std::to_string(*last_s - stamp_s) +
                           " s before the one that came before it; give them in order of time");
  }
  try {
    sources::loadImages(image);
  } catch (const sources::InputDamage& damage) {
    throw core::FrameError(std::string("an observation cannot be used: ") + damage.what());
  }
}

mrpt::poses::CPose3DPDF::Ptr keyframePose(const Eigen::Isometry3d& T_map_base) {
  auto pose = mrpt::poses::CPose3DPDFGaussian::Create(core::toMrpt(T_map_base));
  pose->cov.setDiagonal(6, exchange::kKeyframePoseSigma * exchange::kKeyframePoseSigma);
  return pose;
}

}  // namespace

Session::Session(const MapBuilderConfiguration& configuration, const pipeline::EarlierMap& earlier, bool updatesTheMap,
                 const std::optional<Eigen::Isometry3d>& T_map_base)
    : Session(configuration, slamOptions(configuration, updatesTheMap, T_map_base), earlier) {
  if (T_map_base) T_map_base_ = *T_map_base;
}

Session::Session(const MapBuilderConfiguration& configuration, const pipeline::SlamOptions& slam,
                 const pipeline::EarlierMap& earlier)
    : configuration_(configuration),
      scans_(configuration.builder),
      slam_(slam, earlier, whenBehind(configuration.builder)) {
  if (!configuration.builder.sensor_label.empty()) camera_ = configuration.builder.sensor_label;
  for (const auto& keyframe : earlier.graph.keyframes) keyframes_.insert(keyframe->id);
  slam_.addObserver(*this);
  slam_.addObserver(scans_);
}

void Session::addMotion(const std::optional<odometry::MotionPrior>& motion) {
  if (motion) {
    motion_ = motion_ ? odometry::composed(*motion_, *motion) : *motion;
  } else {
    missedMotion_ = true;
  }
}

/// An observation may hold an image that lies in a file; it is read for as long as it is worked on.
void Session::add(const mrpt::obs::CSensoryFrame& observed) {
  if (isFinished_) throw core::InputError("the map is finished; call initialize() to begin another or go on in one");
  const auto image = cameraAmong(observed);
  for (const auto& observation : observed) {
    if (waiting_.size() < kMostWaiting) waiting_.insert(observation);
  }
  if (!image) return;
  const double stamp_s = core::fromMrptTime(image->timestamp);
  scans_.setObserved(waiting_);
  waiting_.clear();  // also where the image cannot be used
  requireUsable(*image, lastImage_s_);
  soFar_.reset();
  metricMapsAreOld_ = true;
  slam_.process(image, motionUntil(stamp_s));
  lastImage_s_ = stamp_s;
  motion_.reset();
  missedMotion_ = false;
  image->unload();
}

std::optional<odometry::MotionPrior> Session::motionUntil(double stamp_s) const {
  if (motion_ && !missedMotion_) return motion_;
  return lastImage_s_ ? odometer_.between(*lastImage_s_, stamp_s) : std::nullopt;
}

CObservation3DRangeScan::Ptr Session::cameraAmong(const mrpt::obs::CSensoryFrame& observed) {
  for (const auto& observation : observed) {
    const auto scan = std::dynamic_pointer_cast<CObservation3DRangeScan>(observation);
    if (!scan || (camera_ && scan->sensorLabel != *camera_)) continue;
    camera_ = scan->sensorLabel;
    return scan;
  }
  return nullptr;
}

void Session::onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) {
  if (odometry.keyframe) keyframes_.insert(odometry.keyframe->id);
  if (odometry.covariance) {
    T_base_cam_ = frame.T_base_cam;
    const Eigen::Isometry3d T_cam_base = T_base_cam_.inverse();
    T_map_base_ = odometry.T_map_cam * T_cam_base;
    covariance_ = odometry::transformed(*odometry.covariance, T_cam_base);
  } else if (lastSeen_s_) {
    covariance_ = goneSince(frame.stamp_s - *lastSeen_s_, configuration_.slam.odometry.relocalisation);
  }
  if (odometry.hasPose()) lastSeen_s_ = frame.stamp_s;
}

void Session::onUpdate(const odometry::MapUpdate& update) {
  for (const auto& removed : update.removedKeyframes) keyframes_.erase(removed.id);
}

void Session::finish() {
  if (isFinished_) return;
  isFinished_ = true;
  soFar_.reset();
  metricMapsAreOld_ = true;
  slam_.finish();
  const auto& trajectory = soFar().trajectory;
  const bool endsHere = !trajectory.empty() && lastSeen_s_ && trajectory.back().stamp_s == *lastSeen_s_;
  if (endsHere && lastSeen_s_ == lastImage_s_) T_map_base_ = trajectory.back().T_map_cam * T_base_cam_.inverse();
}

mrpt::poses::CPose3DPDFGaussian Session::pose() const { return toGaussian(T_map_base_, covariance_); }

const pipeline::MapSoFar& Session::soFar() {
  if (!soFar_) soFar_ = slam_.mapSoFar();
  return *soFar_;
}

/// Of the keyframes of an earlier map only the map itself is known.
mrpt::maps::CSimpleMap Session::simpleMap() {
  const pipeline::MapSoFar& known = soFar();
  mrpt::maps::CSimpleMap ofEarlierMap;
  mrpt::maps::CSimpleMap simple;
  for (const auto& [id, T_map_cam] : known.T_map_cam) {
    const auto scan = scans_.all().find(id);
    if (scan != scans_.all().end()) {
      simple.insert(keyframePose(T_map_cam * scan->second.T_base_cam.inverse()), scan->second.observed);
      continue;
    }
    const auto earlier = known.semantic.keyframes.find(id);
    if (earlier == known.semantic.keyframes.end()) continue;
    if (ofEarlierMap.empty()) ofEarlierMap = exchange::toSimpleMap(known.semantic);
    simple.insert(*std::next(ofEarlierMap.begin(), std::distance(known.semantic.keyframes.begin(), earlier)));
  }
  return simple;
}

const mrpt::maps::CMultiMetricMap& Session::metricMaps() {
  if (metricMapsAreOld_ || !metricMaps_) {
    metricMaps_ = makeMetricMaps(configuration_.maps, soFar().semantic);
    metricMapsAreOld_ = false;
  }
  return *metricMaps_;
}

}  // namespace wardslam::mrpt_slam
