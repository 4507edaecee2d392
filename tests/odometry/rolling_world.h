#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <vector>

#include "wardslam/core/camera_model.h"
#include "wardslam/core/keypoint.h"

namespace wardslam::test {

/// Points in front of a camera that is turned to and fro by hand, and is read row by row.
class RollingWorld {
 public:
  explicit RollingWorld(double readout_s, std::size_t points = 600, unsigned seed = 1)
      : readout_s_(readout_s), random_(seed) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (std::size_t i = 0; i < points; ++i) {
      points_m_.emplace_back(3.0 * unit(random_), 2.0 * unit(random_), 3.0 + 1.5 * unit(random_));
    }
  }

  /// Up to 1.2 rad/s about all axes, and 0.2 m/s.
  [[nodiscard]] static Eigen::Isometry3d T_world_cam(double t_s) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = (Eigen::AngleAxisd(0.20 * std::sin(6.0 * t_s), Eigen::Vector3d::UnitY()) *
                  Eigen::AngleAxisd(0.15 * std::sin(5.0 * t_s + 1.0), Eigen::Vector3d::UnitX()) *
                  Eigen::AngleAxisd(0.15 * std::sin(4.0 * t_s + 2.0), Eigen::Vector3d::UnitZ()))
                     .toRotationMatrix();
    T.translation() = Eigen::Vector3d(0.05 * std::sin(4.0 * t_s), 0.02 * std::sin(3.0 * t_s), 0.05 * std::sin(2 * t_s));
    return T;
  }

  /// A point as the image shows it whose middle row is read at `t_s`; false where it is out of sight.
  bool see(std::size_t point, double t_s, double pixel_px, core::Keypoint& keypoint) {
    const core::CameraModel camera;
    double late_s = 0.0;
    Eigen::Vector3d p_cam_m;
    Eigen::Vector2d px;
    for (int round = 0; round < 8; ++round) {  // the row tells when, and when tells the row
      p_cam_m = T_world_cam(t_s + late_s).inverse() * points_m_[point];
      if (p_cam_m.z() < 0.5) return false;
      px = camera.project(p_cam_m);
      late_s = readout_s_ * ((px.y() + 0.5) / camera.height_px - 0.5);
    }
    if (px.x() < 0 || px.x() > 639 || px.y() < 0 || px.y() > 479) return false;
    std::normal_distribution<double> normal(0.0, pixel_px);
    keypoint.undistorted_px = {static_cast<float>(px.x() + (pixel_px > 0 ? normal(random_) : 0.0)),
                               static_cast<float>(px.y() + (pixel_px > 0 ? normal(random_) : 0.0))};
    keypoint.raw_px = keypoint.undistorted_px;
    keypoint.depth_m = static_cast<float>(p_cam_m.z());
    return true;
  }

  [[nodiscard]] std::size_t size() const { return points_m_.size(); }
  [[nodiscard]] const Eigen::Vector3d& p_world_m(std::size_t point) const { return points_m_[point]; }

 private:
  double readout_s_;
  std::mt19937 random_;
  std::vector<Eigen::Vector3d> points_m_;
};

}  // namespace wardslam::test
