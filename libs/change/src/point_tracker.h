#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <opencv2/core.hpp>
#include <vector>

#include "wardslam/change/scene_motion_options.h"
#include "wardslam/core/frame.h"

namespace wardslam::change {

/// Depth around a pixel (m); 0 = none.
struct DepthAround {
  double clear_m = 0.0;     ///< At the pixel, where nothing at another depth is near that could be meant instead.
  double nearest_m = 0.0;   ///< Within the window that is followed.
  double farthest_m = 0.0;  ///< The same.
};

/// Where a track was in one image.
struct TrackedPosition {
  std::uint64_t frame = 0;
  Eigen::Vector2d undistorted_px = Eigen::Vector2d::Zero();
  DepthAround depth;
  double moved_px = 0.0;  ///< Since the image before.

  [[nodiscard]] bool hasDepth() const { return depth.clear_m > 0.0; }
};

/// A small patch of the scene, followed from image to image.
struct Track {
  cv::Point2f raw_px;                     ///< In the newest image.
  std::deque<TrackedPosition> positions;  ///< In order of time, one per image; the newest belongs to raw_px.
  double logOdds = 0.0;                   ///< ln (p / (1 − p)) that it moves against the static scene.
  bool isDistrusted = false;              ///< It started on something that moves.
  bool isOnMover = false;                 ///< It is on something known to move.

  /// In image `frame`; null when it was not followed so far back.
  [[nodiscard]] const TrackedPosition* at(std::uint64_t frame) const;
};

/// Follows points by their looks (pyramidal Lucas–Kanade on the half-size image) for as long as they stay in view;
/// new ones start at the key points of the frame where none are followed yet.
class PointTracker {
 public:
  static constexpr int kReach_px = 8;  ///< Of the patch around a point, in the full image.

  explicit PointTracker(const PointTrackerOptions& options) : options_(options) {}

  /// Follows into the next image, whose number is `frameNumber`. `predicted_px` (raw): where each of tracks() should
  /// be. Lost tracks go. Positions before image `oldestFrame` are forgotten.
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

/// Of CV_32FC1 `depth_m` (m, 0 = none) around a raw pixel.
[[nodiscard]] DepthAround depthAround(const cv::Mat& depth_m, const cv::Point2f& raw_px,
                                      const core::DepthNoise& noise = {});

}  // namespace wardslam::change
