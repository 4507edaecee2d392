#pragma once

#include <Eigen/Geometry>

namespace wardslam::synth {

/// How the camera sits on the robot's base (x forward, y left, z up, origin on the floor).
struct CameraMount {
  double height_m = 1.1;
  double pitch_rad = 0.10;  ///< Positive looks down.
  double roll_rad = 0.0;    ///< Positive leans to the right.
};

/// The sensor's frame (x forward, y left, z up) in the base's.
[[nodiscard]] inline Eigen::Isometry3d T_base_sensor(const CameraMount& mount) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation().z() = mount.height_m;
  T.linear() = (Eigen::AngleAxisd(mount.pitch_rad, Eigen::Vector3d::UnitY()) *
                Eigen::AngleAxisd(mount.roll_rad, Eigen::Vector3d::UnitX()))
                   .toRotationMatrix();
  return T;
}

}  // namespace wardslam::synth
