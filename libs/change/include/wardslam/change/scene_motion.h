#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include "wardslam/change/scene_motion_options.h"
#include "wardslam/core/frame.h"

namespace wardslam::change {

class DepthGrid;
struct Track;

/// Motion of whatever is in the picture against the static scene, found from the pictures alone: no classes, no pose
/// from elsewhere, so that a tracker whose pose was pulled cannot pull this along.
///
/// Points are followed from image to image; the motion most of the scene agrees with is the camera's. Against it each
/// point is tested over a window of time in units of its noise, and gathers evidence (log-odds) while it stays in
/// view; and each pixel's depth is tested for whether an earlier image saw through the place it is at now. Where the
/// camera's motion cannot be told (few points, blur), nothing is found and old evidence fades.
class SceneMotion {
 public:
  explicit SceneMotion(const SceneMotionOptions& options);
  ~SceneMotion();
  SceneMotion(SceneMotion&&) noexcept;
  SceneMotion& operator=(SceneMotion&&) noexcept;
  SceneMotion(const SceneMotion&) = delete;
  SceneMotion& operator=(const SceneMotion&) = delete;

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

  /// The points followed, with what is known of each.
  [[nodiscard]] const std::vector<Track>& tracks() const;

  /// Per pixel of grid(), whether earlier images saw the surface there, or through its place: CV_8UC1 of Seen.
  [[nodiscard]] const cv::Mat& space() const;
  [[nodiscard]] const DepthGrid& grid() const;  ///< Of the image last judged.

  /// Whether the camera's motion to the image last given is known.
  [[nodiscard]] bool isTrusted() const;

  /// Whether it is unknown although there were earlier images to compare with.
  [[nodiscard]] bool isAtLoss() const;

 private:
  class Comparison;

  std::unique_ptr<Comparison> comparison_;
};

}  // namespace wardslam::change
