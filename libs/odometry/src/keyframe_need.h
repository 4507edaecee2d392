#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pose_tracker.h"
#include "wardslam/odometry/odometry_options.h"

namespace wardslam::odometry {

/// What became of the last keyframe.
struct SinceKeyframe {
  std::uint64_t frames = 0;
  std::size_t mostTracked = 0;  ///< Points found in one image since then.
  Eigen::Isometry3d T_keyframe_cam = Eigen::Isometry3d::Identity();
};

/// Key points that a keyframe would make points of: with a depth that is not too far, and no point of the map yet.
[[nodiscard]] std::vector<std::size_t> newPoints(const OdometryOptions& options, const TrackedImage& view,
                                                 const Tracking& tracking);

/// Whether this image is to be a keyframe. `newPoints`: what it would add.
[[nodiscard]] bool needsKeyframe(const OdometryOptions& options, const Tracking& tracking, std::size_t newPoints,
                                 const SinceKeyframe& since);

}  // namespace wardslam::odometry
