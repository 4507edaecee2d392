#pragma once

#include <Eigen/Geometry>
#include <random>
#include <vector>

#include "wardslam/core/camera_model.h"
#include "wardslam/odometry/depth_view.h"

namespace wardslam::test {

/// All p with normal . p = distance.
struct Plane {
  Eigen::Vector3d normal;
  double distance_m;
};

/// Depth of bare planes, of each pixel the nearest: no key point anywhere.
class RenderedPlanes {
 public:
  explicit RenderedPlanes(std::vector<Plane> planes, unsigned seed = 1, const core::CameraModel& camera = {})
      : planes_(std::move(planes)), random_(seed), camera_(camera) {}

  /// A corridor along z, 2 m wide and 2.4 m high, without an end in sight.
  static std::vector<Plane> corridor() {
    return {{{1, 0, 0}, -1.0}, {{1, 0, 0}, 1.0}, {{0, 1, 0}, 1.4}, {{0, 1, 0}, -1.0}};
  }
  /// The same with a wall across.
  static std::vector<Plane> room(double end_m = 4.0) {
    auto planes = corridor();
    planes.push_back({{0, 0, 1}, end_m});
    return planes;
  }

  /// `sigmas`: of the Kinect's depth noise, pixel by pixel.
  [[nodiscard]] odometry::DepthImage look(const Eigen::Isometry3d& T_world_cam, double sigmas = 0.0) {
    const core::CameraModel& camera = camera_;
    std::normal_distribution<double> normal;
    cv::Mat depth_m(camera.height_px, camera.width_px, CV_32FC1, cv::Scalar(0));
    for (int y = 0; y < depth_m.rows; ++y) {
      for (int x = 0; x < depth_m.cols; ++x) {
        const double exact_m = depthAlong(camera.unproject(Eigen::Vector2d(x, y), 1.0), T_world_cam);
        if (exact_m > kFarthest_m) continue;
        const double off_m = sigmas > 0.0 ? sigmas * camera.depthNoise.sigma_m(exact_m) * normal(random_) : 0.0;
        depth_m.at<float>(y, x) = static_cast<float>(exact_m + off_m);
      }
    }
    return {depth_m, {}};
  }

 private:
  static constexpr double kFarthest_m = 6.0;

  [[nodiscard]] double depthAlong(const Eigen::Vector3d& ray_cam, const Eigen::Isometry3d& T_world_cam) const {
    const Eigen::Vector3d ray = T_world_cam.linear() * ray_cam;
    double nearest_m = 1e9;
    for (const Plane& plane : planes_) {
      const double depth_m = (plane.distance_m - plane.normal.dot(T_world_cam.translation())) / plane.normal.dot(ray);
      if (depth_m > 0.3) nearest_m = std::min(nearest_m, depth_m);
    }
    return nearest_m;
  }

  std::vector<Plane> planes_;
  std::mt19937 random_;
  core::CameraModel camera_;
};

inline Eigen::Isometry3d moved(const Eigen::Vector3d& translation_m, const Eigen::Vector3d& rotation_rad) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = translation_m;
  const double angle_rad = rotation_rad.norm();
  if (angle_rad > 0) T.linear() = Eigen::AngleAxisd(angle_rad, rotation_rad / angle_rad).toRotationMatrix();
  return T;
}

}  // namespace wardslam::test
