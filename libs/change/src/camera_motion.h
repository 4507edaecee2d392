#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "wardslam/change/scene_motion_options.h"
#include "wardslam/core/camera_model.h"

namespace wardslam::change {

/// A point with depth in image a, found again in image b.
struct PointMatch {
  Eigen::Vector3d p_a_m = Eigen::Vector3d::Zero();
  Eigen::Vector2d b_px = Eigen::Vector2d::Zero();  ///< Undistorted.
  double bDepth_m = 0.0;                           ///< 0 = none.
  double weight = 1.0;                             ///< How much it is believed to be static, 0..1.
  double sigma_px = 1.0;                           ///< Noise of b_px.
};

/// Motion of the camera against the static scene, between two images.
struct CameraMotion {
  Eigen::Isometry3d T_b_a = Eigen::Isometry3d::Identity();
  /// Typical error of what is believed to be static, in units of the expected noise, at least 1. Blur raises it.
  double noiseScale = 1.0;
  bool isTrusted = false;  ///< Enough points, spread over the image, agree.
};

/// Squared error of a match under a motion, in units of its noise: reprojection and, where measured, depth (noise of
/// the sensor in both images, 1 % for its calibration, and what sigma_px makes on a steep surface). Infinite for a
/// point that comes behind the camera.
[[nodiscard]] double squaredError(const PointMatch& match, const Eigen::Isometry3d& T_b_a,
                                  const core::CameraModel& camera);

/// Squared error 99 % of static matches stay below (chi-square with 3 degrees of freedom).
inline constexpr double kChiSquare99 = 11.345;

/// The motion of the static scene: of all rigid motions the one that most matches agree with, counting a match by its
/// weight and no more than a few per cell of the image, so that one mover rich in texture does not outvote a background
/// all around it. Candidates: `guesses` (constant velocity, …) and minimal sets drawn at random by weight. What is
/// known to be static is asked first; the others have a say only when it no longer agrees with itself. Fast motion may
/// blur the images or may not: when most agree as if they were sharp, that is the answer, since to the wider noise of
/// blurred ones a mover could seem to agree with the scene.
class CameraMotionEstimator {
 public:
  explicit CameraMotionEstimator(const CameraMotionOptions& options) : options_(options) {}

  /// The same input gives the same output.
  [[nodiscard]] CameraMotion estimate(const std::vector<PointMatch>& matches, const core::CameraModel& camera,
                                      const std::vector<Eigen::Isometry3d>& guesses) const;

 private:
  [[nodiscard]] CameraMotion estimateFrom(const std::vector<PointMatch>& matches, const core::CameraModel& camera,
                                          const std::vector<Eigen::Isometry3d>& guesses, double minShare) const;

  CameraMotionOptions options_;
};

}  // namespace wardslam::change
