#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <memory>

#include "wardslam/core/ground_plane.h"
#include "wardslam/graph/keyframe_graph.h"

namespace wardslam::test {

/// A robot that drives along x over a ground, a camera 1.1 m above it that looks ahead. Each keyframe sees the ground
/// some way ahead as a plane, to 0.1 degrees and 5 mm; no points.
class FloorWalk {
 public:
  static constexpr double kStep_m = 0.3;
  static constexpr double kEye_m = 1.1;
  static constexpr double kAhead_m = 1.5;

  using Height = std::function<double(double x_m)>;

  explicit FloorWalk(Height height_m) : height_m_(std::move(height_m)) {}

  /// Of the ground at x, upwards along x, rad.
  [[nodiscard]] double slope_rad(double x_m) const {
    return std::atan((height_m_(x_m + 0.01) - height_m_(x_m - 0.01)) / 0.02);
  }

  /// Where the camera truly is, in a map that is level.
  [[nodiscard]] Eigen::Isometry3d T_map_cam(odometry::KeyframeId id) const {
    const double x_m = xOf_m(id);
    Eigen::Matrix3d R_level_cam;  // z ahead, y down
    R_level_cam << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = Eigen::AngleAxisd(-slope_rad(x_m), Eigen::Vector3d::UnitY()).toRotationMatrix() * R_level_cam;
    T.translation() = Eigen::Vector3d(x_m, 0, height_m_(x_m)) + kEye_m * up(slope_rad(x_m));
    return T;
  }

  [[nodiscard]] static double xOf_m(odometry::KeyframeId id) { return kStep_m * static_cast<double>(id - 1); }

  /// The plane at the spot it looks at.
  [[nodiscard]] core::GroundPlane groundOf(odometry::KeyframeId id) const {
    const double x_m = xOf_m(id) + kAhead_m;
    const Eigen::Isometry3d T_cam_map = T_map_cam(id).inverse();
    core::GroundPlane ground;
    ground.normal_cam = T_cam_map.linear() * up(slope_rad(x_m));
    ground.height_m = -ground.normal_cam.dot(T_cam_map * Eigen::Vector3d(x_m, 0, height_m_(x_m)));
    ground.covariance = Eigen::Vector3d(0.0017, 0.0017, 0.005).cwiseAbs2().asDiagonal();
    return ground;
  }

  /// A keyframe of submap 1. `slip` is what tracking does not notice of each step.
  [[nodiscard]] std::shared_ptr<odometry::Keyframe> keyframe(
      odometry::KeyframeId id, const Eigen::Isometry3d& slip = Eigen::Isometry3d::Identity()) const {
    auto keyframe = std::make_shared<odometry::Keyframe>();
    keyframe->id = id;
    keyframe->submap = 1;
    keyframe->T_map_cam = T_map_cam(id);
    if (id > 1) keyframe->T_previous_cam = T_map_cam(id - 1).inverse() * T_map_cam(id) * slip;
    keyframe->features.descriptors = cv::Mat(0, 32, CV_8UC1);
    keyframe->ground = groundOf(id);
    return keyframe;
  }

 private:
  static Eigen::Vector3d up(double slope_rad) { return {-std::sin(slope_rad), 0.0, std::cos(slope_rad)}; }

  Height height_m_;
};

inline double levelGround(double /*x_m*/) { return 0.0; }

/// From 3 m to 6 m, 3 degrees.
inline double ramp(double x_m) { return std::tan(3.0 * M_PI / 180.0) * std::min(std::max(x_m - 3.0, 0.0), 3.0); }

}  // namespace wardslam::test
