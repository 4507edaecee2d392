#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <deque>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "wardslam/change/camera_motion.h"
#include "wardslam/change/free_space.h"
#include "wardslam/change/point_tracker.h"
#include "wardslam/core/frame.h"
#include "wardslam/core/options.h"

namespace wardslam::change {

struct SceneMotionOptions {
  PointTrackerOptions tracker;
  CameraMotionOptions camera;
  double window_s = 0.5;
  double memory_s = 0.7;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    PointTrackerOptions::describe(self.tracker, visit);
    CameraMotionOptions::describe(self.camera, visit);
    visit("window", self.window_s, {0.1, 2.0}, "s", "how far back images are compared; slow things need longer");
    visit("memory", self.memory_s, {0.05, 10.0}, "s", "after this time without new evidence a third of it is left");
  }
};

/// What moves against the static scene, found from the pictures alone: no classes, no pose from elsewhere, so that a
/// tracker whose pose was pulled cannot pull this along.
///
/// Points are followed from image to image; the motion most of the scene agrees with is the camera's. Against it each
/// point is tested over a window of time in units of its noise, and gathers evidence (log-odds) while it stays in
/// view; and each pixel's depth is tested for whether an earlier image saw through the place it is at now. Where the
/// camera's motion cannot be told (few points, blur), nothing is found and old evidence fades.
class SceneMotion {
 public:
  explicit SceneMotion(const SceneMotionOptions& options)
      : options_(options), tracker_(options.tracker), estimator_(options.camera) {}

  /// Follows points into the next image, in order of time. Needs its pictures only, no key points.
  void follow(const core::Frame& frame);

  /// The image followed into, now with its key points. `knownMovers` (CV_8UC1 of the image's size, may be empty):
  /// what surely moves; it does not vote on the camera's motion.
  void judge(const core::Frame& frame, const cv::Mat& knownMovers = {});

  /// Both.
  void update(const core::Frame& frame, const cv::Mat& knownMovers = {}) {
    follow(frame);
    judge(frame, knownMovers);
  }

  /// What was made of the evidence: points that start where `moves` (CV_8UC1 of the image's size) is set count little
  /// when the next images vote on the motion of the camera. About the image last given.
  void distrust(const cv::Mat& moves);

  [[nodiscard]] const std::vector<Track>& tracks() const { return tracker_.tracks(); }

  /// Per pixel of view(): 0 unknown, 1 as before, 2 a surface where an earlier image saw none. CV_8UC1 of Space.
  [[nodiscard]] const cv::Mat& space() const { return space_; }
  [[nodiscard]] const SpaceView& view() const { return moments_.back().view; }

  /// Whether the camera's motion to the image last given is known.
  [[nodiscard]] bool isTrusted() const { return isTrusted_; }

  /// Whether it is unknown although there were earlier images to compare with.
  [[nodiscard]] bool isAtLoss() const { return isCompared_ && !isTrusted_; }

 private:
  /// An image of the window.
  struct Moment {
    std::uint64_t number = 0;
    double stamp_s = 0.0;
    Eigen::Isometry3d T_local_cam = Eigen::Isometry3d::Identity();  ///< Step by step: a first guess only.
    SpaceView view;
  };

  void markKnownMovers(const cv::Mat& knownMovers);
  [[nodiscard]] std::vector<cv::Point2f> predictTracks(const core::CameraModel& camera) const;
  [[nodiscard]] std::vector<PointMatch> matchesSince(const Moment& past, const core::CameraModel& camera) const;
  void locate(Moment& now, const core::CameraModel& camera);
  void gatherEvidence(const Moment& now, const core::CameraModel& camera);
  void testTracks(const Moment& now, const Moment& past, const CameraMotion& motion, const core::CameraModel& camera,
                  std::vector<double>& evidence) const;
  void forget(double stamp_s);
  [[nodiscard]] std::vector<const Moment*> references(double stamp_s) const;

  SceneMotionOptions options_;
  PointTracker tracker_;
  CameraMotionEstimator estimator_;
  std::deque<Moment> moments_;  ///< In order of time; the newest belongs to the image last judged.
  std::optional<Moment> now_;   ///< Followed into, not judged yet.
  Eigen::Isometry3d T_now_before_ = Eigen::Isometry3d::Identity();  ///< The newest step that is known.
  cv::Mat space_;
  std::uint64_t number_ = 0;
  bool isTrusted_ = false;
  bool isCompared_ = false;
};

/// Probability from log-odds.
[[nodiscard]] double probabilityOf(double logOdds);

}  // namespace wardslam::change
