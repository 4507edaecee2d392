#include "wardslam/change/scene_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace wardslam::change {
namespace {

constexpr double kMostLogOdds = 4.0;
// Evidence per image: neighbouring images see the same thing, so each adds little for "static" and is bounded.
constexpr double kMostForMotion = 1.5;
constexpr double kMostForRest = 0.5;
constexpr double kMostForEdges = 0.4;  // where two edges at rest cross in the image, the crossing slides along both
constexpr double kShortestBaseline_s = 0.06;
constexpr double kUnknownDepth_m = 3.0;

Eigen::Vector3d pointOf(const Sighting& sighting, const core::CameraModel& camera, double depth_m) {
  return camera.unproject(sighting.undistorted_px, depth_m);
}

/// Even what seems to move keeps a say: were it silent, an error about the camera could never be found out.
double voteOf(const Track& track) {
  constexpr double kLeast = 0.1;
  constexpr double kDistrust = 1.5;
  if (track.isOnMover) return 0.0;
  return kLeast + (1.0 - kLeast) * probabilityOf(-(track.logOdds + (track.isDistrusted ? kDistrust : 0.0)));
}

/// What moves fast through the image is blurred, its rows are exposed one after the other, and depth is not taken at
/// quite the same time as colour: each some part of the way it goes in one image.
double noiseOf(const Sighting& before, const Sighting& now) {
  constexpr double kStill_px = 1.0;
  constexpr double kPartOfWay = 0.1;
  return std::sqrt(kStill_px * kStill_px +
                   kPartOfWay * kPartOfWay * (before.moved_px * before.moved_px + now.moved_px * now.moved_px));
}

PointMatch matchOf(const Track& track, const Sighting& before, double depth_m, const core::CameraModel& camera) {
  const Sighting& now = track.sightings.back();
  return {pointOf(before, camera, depth_m), now.undistorted_px, now.depth.clear_m, voteOf(track), noiseOf(before, now)};
}

/// How deep the patch may have been: where its window shows an edge, it may be what is in front or what is behind;
/// without any depth it is out of the sensor's range.
std::vector<double> depthsOf(const Sighting& sighting) {
  constexpr double kRange_m = 5.0;
  constexpr double kFar_m = 100.0;
  const auto& [clear_m, nearest_m, farthest_m] = sighting.depth;
  if (clear_m > 0) return {clear_m};
  if (nearest_m > 0) return {nearest_m, farthest_m};
  return {kRange_m, 2 * kRange_m, kFar_m};
}

/// Log-likelihood ratio of "moves" to "rests" for a squared error in units of noise.
double evidenceOf(double squaredError, double baseline, bool hasDepth) {
  const double limit = hasDepth ? kChiSquare99 : 9.21;  // 99 % of chi-square with 3, with 2 degrees of freedom
  const double ratio = 0.25 * (squaredError - limit);
  return std::clamp(ratio, -kMostForRest * baseline, kMostForMotion);
}

}  // namespace

double probabilityOf(double logOdds) { return 1.0 / (1.0 + std::exp(-logOdds)); }

void SceneMotion::follow(const core::Frame& frame) {
  forget(frame.stamp_s);
  const SpaceView* viewBefore = moments_.empty() ? nullptr : &moments_.back().view;
  now_.emplace(Moment{++number_, frame.stamp_s, Eigen::Isometry3d::Identity(),
                      SpaceView(frame.depth_m, frame.camera, viewBefore)});
  const std::uint64_t oldest = moments_.empty() ? number_ : moments_.front().number;
  tracker_.follow(frame, number_, predictTracks(frame.camera), oldest);
}

void SceneMotion::judge(const core::Frame& frame, const cv::Mat& knownMovers) {
  Moment now = std::move(now_).value();
  now_.reset();
  isTrusted_ = isCompared_ = false;
  markKnownMovers(knownMovers);
  locate(now, frame.camera);
  space_ = cv::Mat(now.view.size(), CV_8UC1, cv::Scalar(static_cast<int>(Space::Unknown)));
  if (!moments_.empty()) gatherEvidence(now, frame.camera);
  moments_.push_back(std::move(now));
  tracker_.start(frame, number_);
}

void SceneMotion::markKnownMovers(const cv::Mat& knownMovers) {
  if (knownMovers.empty()) return;
  // A patch that shows part of a mover goes with it.
  cv::Mat around;
  const int side = 2 * PointTracker::kReach_px + 1;
  cv::dilate(knownMovers, around, cv::getStructuringElement(cv::MORPH_RECT, {side, side}));
  for (Track& track : tracker_.tracks()) track.isOnMover = around.at<std::uint8_t>(track.raw_px) != 0;
}

void SceneMotion::distrust(const cv::Mat& moves) {
  for (Track& track : tracker_.tracks()) {
    if (track.sightings.size() == 1 && moves.at<std::uint8_t>(track.raw_px) != 0) track.isDistrusted = true;
  }
}

void SceneMotion::forget(double stamp_s) {
  if (!moments_.empty() && stamp_s <= moments_.back().stamp_s) moments_.clear();
  while (!moments_.empty() && stamp_s - moments_.front().stamp_s > options_.window_s) moments_.pop_front();
}

std::vector<cv::Point2f> SceneMotion::predictTracks(const core::CameraModel& camera) const {
  std::vector<cv::Point2f> predicted_px;
  for (const Track& track : tracks()) {
    const Sighting& last = track.sightings.back();
    const Eigen::Vector3d p_now =
        T_now_before_ * pointOf(last, camera, last.hasDepth() ? last.depth.clear_m : kUnknownDepth_m);
    cv::Point2f px = track.raw_px;
    if (p_now.z() > 0.1) {
      const Eigen::Vector2d projected = camera.projectDistorted(p_now);
      px = {static_cast<float>(projected.x()), static_cast<float>(projected.y())};
    }
    predicted_px.push_back(px);
  }
  return predicted_px;
}

std::vector<PointMatch> SceneMotion::matchesSince(const Moment& past, const core::CameraModel& camera) const {
  std::vector<PointMatch> matches;
  for (const Track& track : tracks()) {
    const Sighting* before = track.at(past.number);
    if (before == nullptr || !before->hasDepth()) continue;
    matches.push_back(matchOf(track, *before, before->depth.clear_m, camera));
  }
  return matches;
}

void SceneMotion::locate(Moment& now, const core::CameraModel& camera) {
  if (moments_.empty()) return;
  const Moment& before = moments_.back();
  const auto step =
      estimator_.estimate(matchesSince(before, camera), camera, {T_now_before_, Eigen::Isometry3d::Identity()});
  if (step.isTrusted) T_now_before_ = step.T_b_a;
  now.T_local_cam = before.T_local_cam * T_now_before_.inverse();
}

std::vector<const SceneMotion::Moment*> SceneMotion::references(double stamp_s) const {
  std::vector<const Moment*> chosen;
  for (const double share : {1.0, 0.4, 0.2}) {
    for (const Moment& moment : moments_) {
      const double age_s = stamp_s - moment.stamp_s;
      if (age_s > share * options_.window_s) continue;
      if (age_s >= kShortestBaseline_s && (chosen.empty() || chosen.back() != &moment)) chosen.push_back(&moment);
      break;
    }
  }
  return chosen;
}

void SceneMotion::gatherEvidence(const Moment& now, const core::CameraModel& camera) {
  auto& tracks = tracker_.tracks();
  std::vector<double> evidence(tracks.size(), 0.0);
  for (const Moment* past : references(now.stamp_s)) {
    isCompared_ = true;
    // Straight to the past image, not step by step: errors do not add up.
    const auto motion =
        estimator_.estimate(matchesSince(*past, camera), camera, {now.T_local_cam.inverse() * past->T_local_cam});
    if (!motion.isTrusted) continue;
    isTrusted_ = true;
    testTracks(now, *past, motion, camera, evidence);
    cv::max(space_, now.view.compareWith(past->view, motion.T_b_a.inverse()), space_);
  }
  const double step_s = now.stamp_s - moments_.back().stamp_s;
  const double kept = std::exp(-step_s / options_.memory_s);
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    tracks[i].logOdds = std::clamp(kept * tracks[i].logOdds + evidence[i], -kMostLogOdds, kMostLogOdds);
  }
}

void SceneMotion::testTracks(const Moment& now, const Moment& past, const CameraMotion& motion,
                             const core::CameraModel& camera, std::vector<double>& evidence) const {
  const double variance = motion.noiseScale * motion.noiseScale;
  const double baseline = (now.stamp_s - past.stamp_s) / options_.window_s;
  for (std::size_t i = 0; i < tracks().size(); ++i) {
    const Track& track = tracks()[i];
    const Sighting* before = track.at(past.number);
    if (before == nullptr) continue;
    double error = std::numeric_limits<double>::infinity();
    for (const double depth_m : depthsOf(*before)) {
      error = std::min(error, squaredError(matchOf(track, *before, depth_m, camera), motion.T_b_a, camera));
    }
    double e = evidenceOf(error / variance, baseline, track.sightings.back().hasDepth());
    if (!before->hasDepth()) e = std::min(e, kMostForEdges);
    double& sum = evidence[i];
    sum = e > 0 || sum > 0 ? std::max(sum, e) : std::min(sum, e);  // seen moving once is moving
  }
}

}  // namespace wardslam::change
