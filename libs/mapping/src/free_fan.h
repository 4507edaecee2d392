#pragma once

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "wardslam/core/camera_model.h"
#include "wardslam/core/ground_plane.h"
#include "wardslam/mapping/floor_planner.h"

namespace wardslam::mapping {

constexpr double kFanDirection_rad = 0.5 * M_PI / 180.0;  ///< From one end point of a fan to the next.

/// The ground a keyframe stands on. One that nobody ever saw is taken to be level and flat, and is not followed.
struct StandingGround {
  core::GroundPlane plane;
  bool isSeen = false;
};

/// How far a keyframe saw nothing in a robot's way: one end point per direction, in the camera frame (m), in order from
/// left to right. `depth_m` as in core::Frame; directions in which nothing was measured are left out. Heights count
/// from the ground, which may rise and fall as a ramp does; what stands over it or falls off ends the way.
[[nodiscard]] std::vector<Eigen::Vector3f> freeFan(const cv::Mat& depth_m, const core::CameraModel& camera,
                                                   const StandingGround& ground, const FloorPlanOptions& options);

}  // namespace wardslam::mapping
