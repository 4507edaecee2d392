#include "keyframe_need.h"

namespace wardslam::odometry {
namespace {

/// From a keyframe whose points are not found to the next one: blur shows others in every image.
constexpr std::uint64_t kLitFrames = 5;

/// In the dark: what the camera sees now hangs on a keyframe that saw as much of it.
bool isFar(const Eigen::Isometry3d& T_keyframe_cam) {
  constexpr double kFar_m = 0.5;
  constexpr double kFar_rad = 0.5;
  return T_keyframe_cam.translation().norm() > kFar_m || Eigen::AngleAxisd(T_keyframe_cam.linear()).angle() > kFar_rad;
}

bool isNeededBesideSurfaces(const OdometryOptions& options, std::size_t newPoints, const SinceKeyframe& since) {
  if (isFar(since.T_keyframe_cam)) return true;
  const bool showsPointsAtLast = since.mostTracked == 0 && static_cast<int>(newPoints) >= options.min_initial_points;
  return showsPointsAtLast && since.frames >= kLitFrames;
}

}  // namespace

std::vector<std::size_t> newPoints(const OdometryOptions& options, const TrackedImage& view, const Tracking& tracking) {
  std::vector<bool> isTaken(view.features.size(), false);
  for (const Match& match : tracking.inliers) isTaken[match.keypoint] = true;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < view.features.size(); ++i) {
    const core::Keypoint& keypoint = view.features.keypoints[i];
    const bool isNear = keypoint.hasDepth() && static_cast<double>(keypoint.depth_m) <= options.local_map.max_depth_m;
    if (isNear && !isTaken[i]) found.push_back(i);
  }
  return found;
}

bool needsKeyframe(const OdometryOptions& options, const Tracking& tracking, std::size_t newPoints,
                   const SinceKeyframe& since) {
  const KeyframeOptions& keyframes = options.keyframes;
  if (tracking.isGuess) return false;
  if (tracking.isHeldByDepth && isNeededBesideSurfaces(options, newPoints, since)) return true;
  if (static_cast<int>(newPoints) < keyframes.min_new_points) return false;
  const bool isLate = since.frames >= static_cast<std::uint64_t>(keyframes.max_frame_gap);
  const bool hasLeft = static_cast<double>(tracking.inliers.size()) <
                       keyframes.min_tracked_fraction * static_cast<double>(since.mostTracked);
  return isLate || hasLeft;
}

}  // namespace wardslam::odometry
