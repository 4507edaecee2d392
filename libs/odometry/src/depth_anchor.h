#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "depth_alignment.h"
#include "wardslam/odometry/odometry_options.h"

namespace wardslam::odometry {

/// A pose that surfaces tell.
struct HeldPose {
  PosePrior pose;
  bool isComplete = true;  ///< Else some directions are open, and as predicted.
};

/// An image not long ago whose surfaces hold the pose where key points do not: in the dark, in fast turns, between bare
/// walls, in a crowd.
class DepthAnchor {
 public:
  explicit DepthAnchor(const DepthAlignmentOptions& options) : options_(options) {}

  /// Of an image whose pose is known; kept once the camera has moved on from the one before. `covariance`: of a pose
  /// that was held itself, so that errors add up; zero where points of the map tell it.
  void remember(const DepthImage& depth, const core::CameraModel& camera, const Eigen::Isometry3d& T_map_cam,
                const PoseCovariance& covariance);
  void forget() { image_.reset(); }
  void move(const Eigen::Isometry3d& correction);

  /// Whether surfaces of this image alone would tell all of the camera's motion.
  [[nodiscard]] bool wouldHold(const DepthImage& depth, const core::CameraModel& camera) const;

  /// Where the camera is by what its image and the remembered one both show, and by where it was predicted, each as
  /// sure as it is: along open directions the prediction alone counts. `T_cam_map_start`: where to begin. Nothing where
  /// they do not show enough, do not fit, or the pose would be a guess.
  [[nodiscard]] std::optional<HeldPose> hold(const DepthImage& depth, const core::CameraModel& camera,
                                             const PosePrior& predicted,
                                             const Eigen::Isometry3d& T_cam_map_start) const;

 private:
  struct Image {
    DepthSurface surface;
    Eigen::Isometry3d T_map_cam;
    PoseCovariance covariance;
  };
  [[nodiscard]] bool isNear(const Eigen::Isometry3d& T_map_cam) const;

  const DepthAlignmentOptions& options_;
  std::optional<Image> image_;
};

}  // namespace wardslam::odometry
