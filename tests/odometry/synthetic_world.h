#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "wardslam/core/camera_model.h"
#include "wardslam/core/depth_noise.h"
#include "wardslam/core/keypoint.h"
#include "wardslam/odometry/orb_descriptor.h"

namespace wardslam::test {

/// What a measurement adds to the truth.
struct Noise {
  double pixel_px = 0.0;         ///< Standard deviation, times the key point's scale.
  double depthSigmaScale = 0.0;  ///< Times the Kinect's depth noise.
  int descriptorBits = 0;        ///< Bits of each descriptor that flip.
};

/// Points strewn over a box (if nothing else is said: in front of the start), each with a descriptor of its own, and
/// exact views of them.
class SyntheticWorld {
 public:
  explicit SyntheticWorld(std::size_t points = 3000, unsigned seed = 1,
                          const Eigen::Vector3d& centre_m = {0.0, 0.0, 3.5},
                          const Eigen::Vector3d& halfSize_m = {4.0, 2.5, 2.3})
      : random_(seed) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (std::size_t i = 0; i < points; ++i) {
      const Eigen::Vector3d inUnitBox{unit(random_), unit(random_), unit(random_)};
      points_.push_back({centre_m + halfSize_m.cwiseProduct(inUnitBox), randomDescriptor()});
    }
  }

  [[nodiscard]] const Eigen::Vector3d& p_world_m(std::size_t point) const { return points_[point].p_world_m; }

  /// The point behind each key point of look().
  [[nodiscard]] std::vector<std::size_t> inSight(const Eigen::Isometry3d& T_world_cam) const {
    const Eigen::Isometry3d T_cam_world = T_world_cam.inverse();
    std::vector<std::size_t> points;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (pixelOf(T_cam_world * points_[i].p_world_m)) points.push_back(i);
    }
    return points;
  }

  /// The points in sight, farther than half a metre, as key points in the order of the points.
  [[nodiscard]] core::Features look(const Eigen::Isometry3d& T_world_cam, const Noise& noise = {}) {
    const Eigen::Isometry3d T_cam_world = T_world_cam.inverse();
    core::Features features;
    for (const Point& point : points_) {
      const auto keypoint = see(T_cam_world * point.p_world_m, noise);
      if (!keypoint) continue;
      features.keypoints.push_back(*keypoint);
      auto descriptor = point.descriptor;
      for (int bit = 0; bit < noise.descriptorBits; ++bit) flip(descriptor, random_() % 256);
      features.descriptors.push_back(cv::Mat(1, 32, CV_8UC1, descriptor.data()));
    }
    return features;
  }

  /// As many key points that belong to nothing.
  [[nodiscard]] core::Features lookElsewhere(std::size_t count) {
    std::uniform_real_distribution<float> unit(0.0F, 1.0F);
    core::Features features;
    for (std::size_t i = 0; i < count; ++i) {
      core::Keypoint keypoint;
      keypoint.raw_px = keypoint.undistorted_px = {639.0F * unit(random_), 479.0F * unit(random_)};
      keypoint.depth_m = 1.0F + 4.0F * unit(random_);
      features.keypoints.push_back(keypoint);
      auto descriptor = randomDescriptor();
      features.descriptors.push_back(cv::Mat(1, 32, CV_8UC1, descriptor.data()));
    }
    return features;
  }

  [[nodiscard]] static core::CameraModel camera() { return {}; }

  /// A bow of a metre to the right, looking about, in `images` steps.
  [[nodiscard]] static Eigen::Isometry3d T_world_cam(int image, int images) {
    const double t = static_cast<double>(image) / images;
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.translation() = Eigen::Vector3d(t, 0.1 * std::sin(6.0 * t), 0.3 * t * t);
    T.linear() = (Eigen::AngleAxisd(0.4 * std::sin(3.0 * t), Eigen::Vector3d::UnitY()) *
                  Eigen::AngleAxisd(0.2 * t, Eigen::Vector3d::UnitZ()))
                     .toRotationMatrix();
    return T;
  }

 private:
  struct Point {
    Eigen::Vector3d p_world_m;
    odometry::OrbDescriptor descriptor;
  };

  [[nodiscard]] static std::optional<Eigen::Vector2d> pixelOf(const Eigen::Vector3d& p_cam_m) {
    if (p_cam_m.z() < 0.5) return std::nullopt;
    const Eigen::Vector2d px = camera().project(p_cam_m);
    if (px.x() < 0 || px.x() > 639 || px.y() < 0 || px.y() > 479) return std::nullopt;
    return px;
  }

  [[nodiscard]] std::optional<core::Keypoint> see(const Eigen::Vector3d& p_cam_m, const Noise& noise) {
    const auto px = pixelOf(p_cam_m);
    if (!px) return std::nullopt;
    std::normal_distribution<double> normal;
    core::Keypoint keypoint;
    keypoint.undistorted_px = {static_cast<float>(px->x() + noise.pixel_px * normal(random_)),
                               static_cast<float>(px->y() + noise.pixel_px * normal(random_))};
    keypoint.raw_px = keypoint.undistorted_px;
    const double sigma_m = noise.depthSigmaScale * core::DepthNoise().sigma_m(p_cam_m.z());
    keypoint.depth_m = static_cast<float>(p_cam_m.z() + sigma_m * normal(random_));
    return keypoint;
  }

  odometry::OrbDescriptor randomDescriptor() {
    odometry::OrbDescriptor descriptor;
    for (auto& byte : descriptor) byte = static_cast<std::uint8_t>(random_());
    return descriptor;
  }

  static void flip(odometry::OrbDescriptor& descriptor, unsigned long bit) {
    descriptor[bit / 8] = static_cast<std::uint8_t>(descriptor[bit / 8] ^ (1U << (bit % 8)));
  }

  std::mt19937 random_;
  std::vector<Point> points_;
};

}  // namespace wardslam::test
