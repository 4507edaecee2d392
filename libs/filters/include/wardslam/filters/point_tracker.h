#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <opencv2/core.hpp>
#include <vector>

#include "wardslam/core/frame.h"

namespace wardslam::filters {

/// Where a track was in one image.
struct Sighting {
  std::uint64_t frame = 0;
  Eigen::Vector2d undistorted_px = Eigen::Vector2d::Zero();
  double depth_m = 0.0;   ///< 0 = none, or at an edge, where it may belong to something else.
  double moved_px = 0.0;  ///< Since the image before.

  [[nodiscard]] bool hasDepth() const { return depth_m > 0.0; }
};

/// A small patch of the scene, followed from image to image.
struct Track {
  cv::Point2f raw_px;              ///< In the newest image.
  std::deque<Sighting> sightings;  ///< In order of time, one per image; the newest belongs to raw_px.
  double logOdds = 0.0;            ///< ln (p / (1 − p)) that it moves against the static scene.
  bool isDistrusted = false;       ///< It started on something that moves.

  /// In image `frame`; null when it was not followed so far back.
  [[nodiscard]] const Sighting* at(std::uint64_t frame) const;
};

struct PointTrackerOptions {
  int points = 500;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("points", self.points, {50, 5000}, "count", "points followed from image to image, at most");
  }
};

/// Follows points by their looks (pyramidal Lucas–Kanade on the half-size image) for as long as they stay in view;
/// new ones start at the key points of the frame where none are followed yet.
class PointTracker {
 public:
  explicit PointTracker(const PointTrackerOptions& options) : options_(options) {}

  /// Follows into the next image, whose number is `frameNumber`. `predicted_px` (raw): where each of tracks() should
  /// be. Lost tracks go. Sightings before image `oldestFrame` are forgotten.
  void follow(const core::Frame& frame, std::uint64_t frameNumber, const std::vector<cv::Point2f>& predicted_px,
              std::uint64_t oldestFrame);

  /// Starts new tracks at key points of the image last followed into.
  void start(const core::Frame& frame, std::uint64_t frameNumber);

  [[nodiscard]] std::vector<Track>& tracks() { return tracks_; }
  [[nodiscard]] const std::vector<Track>& tracks() const { return tracks_; }

 private:
  PointTrackerOptions options_;
  std::vector<Track> tracks_;
  std::vector<cv::Mat> pyramid_;  ///< Of the newest image.
};

/// Depth (m) at a raw pixel of CV_32FC1 `depth_m`; 0 where there is none or where the surroundings (5×5) jump, so that
/// it may be that of the neighbour.
[[nodiscard]] double clearDepthAt(const cv::Mat& depth_m, const cv::Point2f& raw_px);

}  // namespace wardslam::filters
