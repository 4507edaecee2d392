#include "camera_path.h"

#include <cmath>

#include "wardslam/core/mrpt_compat.h"

namespace wardslam::synth {
namespace {

constexpr double kTwoPi = 6.283185307179586;

/// A sine with a whole number of cycles per round: the path closes.
double sway(double t_s, double period_s, int cycles, double phase_rad) {
  return std::sin(kTwoPi * cycles * t_s / period_s + phase_rad);
}

}  // namespace

Eigen::Isometry3d CameraPath::T_world_cam(double t_s) const {
  const double angle = startAngle_rad + kTwoPi * t_s / period_s;
  const Eigen::Vector3d p(centre_m.x() - semiAxes_m.x() * std::cos(angle),
                          centre_m.y() - semiAxes_m.y() * std::sin(angle),
                          height_m + 0.006 * sway(t_s, period_s, 23, 0.4));
  // The base turns ahead of the bend (factor 2.5), slower than the tangent of so flat an ellipse.
  const double along = std::atan2(-std::cos(angle), 2.5 * std::sin(angle));
  const double yaw = along + 0.22 * sway(t_s, period_s, 5, 0.0) + 0.008 * sway(t_s, period_s, 31, 1.0);
  const double pitch = 0.10 + 0.035 * sway(t_s, period_s, 7, 0.7) + 0.004 * sway(t_s, period_s, 37, 0.0);
  const double roll = 0.008 * sway(t_s, period_s, 9, 2.0);

  Eigen::Isometry3d T_world_sensor = Eigen::Isometry3d::Identity();
  T_world_sensor.translation() = p;
  T_world_sensor.linear() =
      (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  return T_world_sensor * core::T_sensor_cam();
}

}  // namespace wardslam::synth
