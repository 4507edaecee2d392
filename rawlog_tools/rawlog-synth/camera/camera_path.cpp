#include "camera/camera_path.h"

#include <cmath>

#include "wardslam/core/mrpt_compat.h"

namespace wardslam::synth {
namespace {

constexpr double kTwoPi = 6.283185307179586;

/// A sine with a whole number of cycles per round: the path closes.
double sway(double rounds, int cycles, double phase_rad) { return std::sin(kTwoPi * cycles * rounds + phase_rad); }

}  // namespace

Eigen::Isometry3d drivenCamera(const DrivenPlace& place, double rounds) {
  const double yaw = place.yaw_rad + place.looksAbout_rad * sway(rounds, 5, 0.0) + 0.008 * sway(rounds, 31, 1.0);
  const double pitch = place.mount.pitch_rad + 0.035 * sway(rounds, 7, 0.7) + 0.004 * sway(rounds, 37, 0.0);
  const double roll = place.mount.roll_rad + 0.008 * sway(rounds, 9, 2.0);

  Eigen::Isometry3d T_world_sensor = Eigen::Isometry3d::Identity();
  T_world_sensor.translation() << place.p_m, place.mount.height_m + 0.006 * sway(rounds, 23, 0.4);
  T_world_sensor.linear() =
      (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  return T_world_sensor * core::T_sensor_cam();
}

Eigen::Isometry3d CameraPath::T_world_cam(double t_s) const {
  const double angle = startAngle_rad + kTwoPi * t_s / period_s;
  const Eigen::Vector2d p(centre_m.x() - semiAxes_m.x() * std::cos(angle),
                          centre_m.y() - semiAxes_m.y() * std::sin(angle));
  // The base turns ahead of the bend (factor 2.5), slower than the tangent of so flat an ellipse.
  const double along = std::atan2(-std::cos(angle), 2.5 * std::sin(angle));
  return drivenCamera({p, along, 0.22, mount}, t_s / period_s);
}

}  // namespace wardslam::synth
