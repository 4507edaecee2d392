#pragma once

#include <Eigen/Geometry>

#include "camera/camera_mount.h"

namespace wardslam::synth {

/// Where a robot's base is, and how far its head turns from side to side.
struct DrivenPlace {
  Eigen::Vector2d p_m = Eigen::Vector2d::Zero();
  double yaw_rad = 0.0;
  double looksAbout_rad = 0.0;
  CameraMount mount = {};
};

/// The optical frame (x right, y down, z forward) of a camera on that base, which sways as it drives; `rounds` driven
/// so far.
[[nodiscard]] Eigen::Isometry3d drivenCamera(const DrivenPlace& place, double rounds);

/// How the camera drives: along an ellipse, again and again, looking about as a robot does on its way.
struct CameraPath {
  Eigen::Vector2d centre_m{4.2, 3.2};
  Eigen::Vector2d semiAxes_m{2.7, 0.62};
  CameraMount mount = {};
  double period_s = 38.0;
  double startAngle_rad = 0.9;  ///< Along the ellipse, from its west end, counter-clockwise.

  /// The optical frame (x right, y down, z forward) in the world frame.
  [[nodiscard]] Eigen::Isometry3d T_world_cam(double t_s) const;
};

}  // namespace wardslam::synth
