#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "wardslam/core/camera_model.h"
#include "wardslam/core/keypoint.h"
#include "wardslam/odometry/motion_prior.h"
#include "wardslam/odometry/odometry_options.h"

namespace wardslam::odometry {

/// A known point of the map seen as a key point.
struct PointObservation {
  Eigen::Vector3d p_map_m = Eigen::Vector3d::Zero();
  core::Keypoint keypoint;
};

struct PoseEstimate {
  Eigen::Isometry3d T_cam_map = Eigen::Isometry3d::Identity();
  std::vector<bool> isInlier;  ///< Per observation.
  int inliers = 0;
};

/// Robust camera pose from points of the map: least squares over reprojection and, where measured, depth, each in
/// units of its standard deviation (depth by the Kinect's noise model).
class PoseSolver {
 public:
  explicit PoseSolver(const PoseSolverOptions& options) : options_(options) {}

  /// From a guess that is near. Fewer than three observations: the guess, without inliers. `prior` (may be null) is
  /// one more measurement, by its covariance; what contradicts the image by far (wheels that slip) pulls no harder than
  /// what just does.
  [[nodiscard]] PoseEstimate refine(const std::vector<PointObservation>& observations, const core::CameraModel& camera,
                                    const Eigen::Isometry3d& T_cam_map_guess, const PosePrior* prior = nullptr) const;

  /// How sure a pose that rests on these observations is (as MotionPrior has it, in the camera frame), were the points
  /// of the map exact. What no observation says has a huge variance.
  [[nodiscard]] PoseCovariance covariance(const std::vector<PointObservation>& observations,
                                          const core::CameraModel& camera, const Eigen::Isometry3d& T_cam_map,
                                          const PosePrior* prior = nullptr) const;

  /// From nothing (RANSAC over minimal sets), then refined. No pose found: no inliers.
  [[nodiscard]] PoseEstimate solve(const std::vector<PointObservation>& observations,
                                   const core::CameraModel& camera) const;

 private:
  PoseSolverOptions options_;
};

}  // namespace wardslam::odometry
