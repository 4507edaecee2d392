#pragma once

#include <Eigen/Geometry>
#include <memory>
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

  /// The image that the functions below are about.
  void see(const DepthImage& depth, const core::CameraModel& camera);

  /// Where it was taken is known; kept once the camera has moved on from the one before. `covariance`: of a pose that
  /// was held itself, so that errors add up; zero where points of the map tell it.
  void remember(const Eigen::Isometry3d& T_map_cam, const PoseCovariance& covariance);
  void forget() { anchor_.reset(); }
  void move(const Eigen::Isometry3d& correction);

  /// Whether surfaces of this image alone would tell all of the camera's motion.
  [[nodiscard]] bool wouldHold();

  /// Where the camera is by what its image and the remembered one both show, and by where it was predicted, each as
  /// sure as it is: along open directions the prediction alone counts. `T_cam_map_start`: where to begin, `start`: how
  /// near that is. Nothing where they do not show enough, do not fit, or the pose would be a guess.
  [[nodiscard]] std::optional<HeldPose> hold(const PosePrior& predicted, const Eigen::Isometry3d& T_cam_map_start,
                                             AlignmentStart start);

 private:
  struct Anchor {
    std::shared_ptr<const DepthSurface> surface;
    Eigen::Isometry3d T_map_cam;
    PoseCovariance covariance;
  };
  [[nodiscard]] bool isNear(const Eigen::Isometry3d& T_map_cam) const;
  const std::shared_ptr<const DepthSurface>& surface();

  const DepthAlignmentOptions& options_;
  std::optional<Anchor> anchor_;
  DepthImage depth_;
  std::shared_ptr<const SquareRays> squares_;    ///< Of the camera it is seen with.
  std::shared_ptr<const DepthSurface> surface_;  ///< Of this image, once it was asked for.
};

}  // namespace wardslam::odometry
