#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "wardslam/core/trajectory.h"
#include "wardslam/odometry/motion_prior.h"
#include "wardslam/odometry/smoothing_options.h"

namespace wardslam::odometry {

/// What is known of where the camera was at a time.
struct EstimatedPose {
  double stamp_s = 0.0;
  Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
  std::optional<PoseCovariance> covariance;  ///< As OdometryResult::covariance. Nothing: it stays, if it was seen.
  bool isSeen = true;                        ///< By the image of that time. Else it was led there, or nobody knows.

  [[nodiscard]] bool isKnown() const { return isSeen || covariance; }
  [[nodiscard]] bool isExact() const { return isSeen && !covariance; }
};

/// The likeliest way through poses measured one by one, in order of time: each is as sure as its covariance says, and
/// between them the camera goes on as it went, changing its velocity and how fast it turns by white noise (the
/// white-noise-on-acceleration prior of continuous-time estimation; Barfoot, State Estimation for Robotics,
/// 2017, 11.1). Noise of single images, which no camera can follow, goes. Images not seen between two that are, at most
/// `longest_bridge_s` apart, get a pose on that way (StampedPose::isBridged); others get none.
[[nodiscard]] core::Trajectory smoothed(const std::vector<EstimatedPose>& poses, const SmoothingOptions& options);

}  // namespace wardslam::odometry
