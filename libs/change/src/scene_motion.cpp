#include "wardslam/change/scene_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>

#include "camera_motion.h"
#include "evidence.h"
#include "free_space.h"
#include "moment_window.h"
#include "point_tracker.h"

namespace wardslam::change {
namespace {

constexpr double kMostForEdges = 0.4;  // where two edges at rest cross in the image, the crossing slides along both
constexpr double kShortestBaseline_s = 0.06;
constexpr double kUnknownDepth_m = 3.0;

Eigen::Vector3d pointOf(const TrackedPosition& position, const core::CameraModel& camera, double depth_m) {
  return camera.unproject(position.undistorted_px, depth_m);
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
double noiseOf(const TrackedPosition& before, const TrackedPosition& now) {
  constexpr double kStill_px = 1.0;
  constexpr double kPartOfWay = 0.1;
  return std::sqrt(kStill_px * kStill_px +
                   kPartOfWay * kPartOfWay * (before.moved_px * before.moved_px + now.moved_px * now.moved_px));
}

PointMatch matchOf(const Track& track, const TrackedPosition& before, double depth_m, const core::CameraModel& camera) {
  const TrackedPosition& now = track.positions.back();
  return {pointOf(before, camera, depth_m), now.undistorted_px, now.depth.clear_m, voteOf(track), noiseOf(before, now)};
}

/// How deep the patch may have been: where its window shows an edge, it may be what is in front or what is behind;
/// without any depth it is out of the sensor's range.
std::vector<double> depthsOf(const TrackedPosition& position) {
  constexpr double kRange_m = 5.0;
  constexpr double kFar_m = 100.0;
  const auto& [clear_m, nearest_m, farthest_m] = position.depth;
  if (clear_m > 0) return {clear_m};
  if (nearest_m > 0) return {nearest_m, farthest_m};
  return {kRange_m, 2 * kRange_m, kFar_m};
}

/// 99 % of what rests stays below.
double limitOf(const TrackedPosition& now) {
  constexpr double kChiSquare99OfTwo = 9.21;  // with 2 degrees of freedom: no depth
  return now.hasDepth() ? kChiSquare99 : kChiSquare99OfTwo;
}

/// An image of the window.
struct Moment {
  std::uint64_t number = 0;
  double stamp_s = 0.0;
  Eigen::Isometry3d T_local_cam = Eigen::Isometry3d::Identity();  ///< Step by step: a first guess only.
  DepthGrid grid;
};

}  // namespace

class SceneMotion::Comparison {
 public:
  explicit Comparison(const SceneMotionOptions& options)
      : options_(options),
        tracker_(options.tracker),
        estimator_(options.camera),
        moments_(options.window_s, kShortestBaseline_s) {}

  void follow(const core::Frame& frame);
  void judge(const core::Frame& frame, const cv::Mat& knownMovers);
  void distrust(const cv::Mat& moves);

  [[nodiscard]] const std::vector<Track>& tracks() const { return tracker_.tracks(); }
  [[nodiscard]] const cv::Mat& space() const { return space_; }
  [[nodiscard]] const DepthGrid& grid() const { return moments_.newest().grid; }
  [[nodiscard]] bool isTrusted() const { return isTrusted_; }
  [[nodiscard]] bool isAtLoss() const { return isCompared_ && !isTrusted_; }

 private:
  void markKnownMovers(const cv::Mat& knownMovers);
  [[nodiscard]] std::vector<cv::Point2f> predictTracks(const core::CameraModel& camera) const;
  [[nodiscard]] std::vector<PointMatch> matchesSince(const Moment& past, const core::CameraModel& camera) const;
  void locate(Moment& now, const core::CameraModel& camera);
  void gatherEvidence(const Moment& now, const core::CameraModel& camera);
  void testTracks(const Moment& now, const Moment& past, const CameraMotion& motion, const core::CameraModel& camera,
                  std::vector<double>& evidence) const;

  SceneMotionOptions options_;
  PointTracker tracker_;
  CameraMotionEstimator estimator_;
  MomentWindow<Moment> moments_;                                    ///< The newest belongs to the image last judged.
  std::optional<Moment> now_;                                       ///< Followed into, not judged yet.
  Eigen::Isometry3d T_now_before_ = Eigen::Isometry3d::Identity();  ///< The newest step that is known.
  cv::Mat space_;
  std::uint64_t number_ = 0;
  bool isTrusted_ = false;
  bool isCompared_ = false;
};

void SceneMotion::Comparison::follow(const core::Frame& frame) {
  moments_.advanceTo(frame.stamp_s);
  const DepthGrid* gridBefore = moments_.empty() ? nullptr : &moments_.newest().grid;
  now_.emplace(Moment{++number_, frame.stamp_s, Eigen::Isometry3d::Identity(),
                      DepthGrid(frame.depth_m, frame.camera, gridBefore)});
  const std::uint64_t oldest = moments_.empty() ? number_ : moments_.oldest().number;
  tracker_.follow(frame, number_, predictTracks(frame.camera), oldest);
}

void SceneMotion::Comparison::judge(const core::Frame& frame, const cv::Mat& knownMovers) {
  Moment now = std::move(now_).value();
  now_.reset();
  isTrusted_ = isCompared_ = false;
  markKnownMovers(knownMovers);
  locate(now, frame.camera);
  space_ = cv::Mat(now.grid.size(), CV_8UC1, cv::Scalar(static_cast<int>(Seen::Unknown)));
  if (!moments_.empty()) gatherEvidence(now, frame.camera);
  moments_.add(std::move(now));
  tracker_.start(frame, number_);
}

void SceneMotion::Comparison::markKnownMovers(const cv::Mat& knownMovers) {
  if (knownMovers.empty()) return;
  // A patch that shows part of a mover goes with it.
  cv::Mat around;
  const int side = 2 * PointTracker::kReach_px + 1;
  cv::dilate(knownMovers, around, cv::getStructuringElement(cv::MORPH_RECT, {side, side}));
  for (Track& track : tracker_.tracks()) track.isOnMover = around.at<std::uint8_t>(track.raw_px) != 0;
}

void SceneMotion::Comparison::distrust(const cv::Mat& moves) {
  for (Track& track : tracker_.tracks()) {
    if (track.positions.size() == 1 && moves.at<std::uint8_t>(track.raw_px) != 0) track.isDistrusted = true;
  }
}

std::vector<cv::Point2f> SceneMotion::Comparison::predictTracks(const core::CameraModel& camera) const {
  std::vector<cv::Point2f> predicted_px;
  for (const Track& track : tracks()) {
    const TrackedPosition& last = track.positions.back();
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

std::vector<PointMatch> SceneMotion::Comparison::matchesSince(const Moment& past,
                                                              const core::CameraModel& camera) const {
  std::vector<PointMatch> matches;
  for (const Track& track : tracks()) {
    const TrackedPosition* before = track.at(past.number);
    if (before == nullptr || !before->hasDepth()) continue;
    matches.push_back(matchOf(track, *before, before->depth.clear_m, camera));
  }
  return matches;
}

void SceneMotion::Comparison::locate(Moment& now, const core::CameraModel& camera) {
  if (moments_.empty()) return;
  const Moment& before = moments_.newest();
  const auto step =
      estimator_.estimate(matchesSince(before, camera), camera, {T_now_before_, Eigen::Isometry3d::Identity()});
  if (step.isTrusted) T_now_before_ = step.T_b_a;
  now.T_local_cam = before.T_local_cam * T_now_before_.inverse();
}

void SceneMotion::Comparison::gatherEvidence(const Moment& now, const core::CameraModel& camera) {
  auto& tracks = tracker_.tracks();
  std::vector<double> evidence(tracks.size(), 0.0);
  for (const Moment* past : moments_.references(now.stamp_s)) {
    isCompared_ = true;
    // Straight to the past image, not step by step: errors do not add up.
    const auto motion =
        estimator_.estimate(matchesSince(*past, camera), camera, {now.T_local_cam.inverse() * past->T_local_cam});
    if (!motion.isTrusted) continue;
    isTrusted_ = true;
    testTracks(now, *past, motion, camera, evidence);
    cv::max(space_, now.grid.compareWith(past->grid, motion.T_b_a.inverse()), space_);
  }
  const double step_s = now.stamp_s - moments_.newest().stamp_s;
  const double kept = std::exp(-step_s / options_.memory_s);
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    tracks[i].logOdds = updated(tracks[i].logOdds, kept, evidence[i]);
  }
}

void SceneMotion::Comparison::testTracks(const Moment& now, const Moment& past, const CameraMotion& motion,
                                         const core::CameraModel& camera, std::vector<double>& evidence) const {
  const double variance = motion.noiseScale * motion.noiseScale;
  const double baseline = moments_.baseline(past, now.stamp_s);
  for (std::size_t i = 0; i < tracks().size(); ++i) {
    const Track& track = tracks()[i];
    const TrackedPosition* before = track.at(past.number);
    if (before == nullptr) continue;
    double error = std::numeric_limits<double>::infinity();
    for (const double depth_m : depthsOf(*before)) {
      error = std::min(error, squaredError(matchOf(track, *before, depth_m, camera), motion.T_b_a, camera));
    }
    double e = evidenceOfError(error / variance, limitOf(track.positions.back()), baseline);
    if (!before->hasDepth()) e = std::min(e, kMostForEdges);
    evidence[i] = combined(evidence[i], e);
  }
}

SceneMotion::SceneMotion(const SceneMotionOptions& options) : comparison_(std::make_unique<Comparison>(options)) {}
SceneMotion::~SceneMotion() = default;
SceneMotion::SceneMotion(SceneMotion&&) noexcept = default;
SceneMotion& SceneMotion::operator=(SceneMotion&&) noexcept = default;

void SceneMotion::follow(const core::Frame& frame) { comparison_->follow(frame); }
void SceneMotion::judge(const core::Frame& frame, const cv::Mat& knownMovers) {
  comparison_->judge(frame, knownMovers);
}
void SceneMotion::distrust(const cv::Mat& moves) { comparison_->distrust(moves); }
const std::vector<Track>& SceneMotion::tracks() const { return comparison_->tracks(); }
const cv::Mat& SceneMotion::space() const { return comparison_->space(); }
const DepthGrid& SceneMotion::grid() const { return comparison_->grid(); }
bool SceneMotion::isTrusted() const { return comparison_->isTrusted(); }
bool SceneMotion::isAtLoss() const { return comparison_->isAtLoss(); }

}  // namespace wardslam::change
