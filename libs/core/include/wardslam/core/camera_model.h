#pragma once

#include <Eigen/Core>
#include <opencv2/core/types.hpp>
#include <optional>
#include <tuple>
#include <vector>

#include "wardslam/core/depth_noise.h"
#include "wardslam/core/sensor_traits.h"

namespace mrpt::img {
class TCamera;
}

namespace wardslam::core {

/// Pinhole camera with the plumb-bob (Brown–Conrady) lens model: what MRPT, OpenCV and ROS call k1 k2 p1 p2 k3.
/// Pixel (0, 0) is the centre of the top left pixel. The optical frame is x right, y down, z forward.
struct CameraModel {
  int width_px = 640;
  int height_px = 480;
  double fx_px = 525.0;
  double fy_px = 525.0;
  double cx_px = 319.5;
  double cy_px = 239.5;
  double k1 = 0.0;
  double k2 = 0.0;
  double p1 = 0.0;
  double p2 = 0.0;
  double k3 = 0.0;
  DepthNoise depthNoise;   ///< Of the depth registered to the image.
  double readout_s = 0.0;  ///< From the first row to the last, negative where read from below; 0 = not known.

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit);

  [[nodiscard]] SensorTraits traits() const { return {depthNoise, readout_s}; }

  [[nodiscard]] bool hasDistortion() const { return k1 != 0 || k2 != 0 || p1 != 0 || p2 != 0 || k3 != 0; }

  /// Whether both show the same, when they stand still.
  [[nodiscard]] bool operator==(const CameraModel& other) const {
    const auto values = [](const CameraModel& c) {
      return std::tuple(c.width_px, c.height_px, c.fx_px, c.fy_px, c.cx_px, c.cy_px, c.k1, c.k2, c.p1, c.p2, c.k3);
    };
    return values(*this) == values(other) && depthNoise == other.depthNoise;
  }

  /// Point in the camera frame (m, z > 0) to the *undistorted* (ideal pinhole) pixel.
  [[nodiscard]] Eigen::Vector2d project(const Eigen::Vector3d& p_cam) const {
    return {fx_px * p_cam.x() / p_cam.z() + cx_px, fy_px * p_cam.y() / p_cam.z() + cy_px};
  }

  /// Undistorted pixel and depth (m, along the optical axis) to the point in the camera frame (m).
  [[nodiscard]] Eigen::Vector3d unproject(const Eigen::Vector2d& undistorted_px, double depth_m) const {
    return {(undistorted_px.x() - cx_px) / fx_px * depth_m, (undistorted_px.y() - cy_px) / fy_px * depth_m, depth_m};
  }

  /// Undistorted pixel of every pixel as measured in the raw image.
  [[nodiscard]] std::vector<cv::Point2f> undistort(const std::vector<cv::Point2f>& raw_px) const;

  /// Raw-image pixel of a point in the camera frame (m, z > 0), lens distortion applied.
  [[nodiscard]] Eigen::Vector2d projectDistorted(const Eigen::Vector3d& p_cam) const;

  /// The same, where the camera sees it: in front of it, inside the raw image, and not beyond where the lens model
  /// folds back (there its polynomial leads far points into the image again).
  [[nodiscard]] std::optional<Eigen::Vector2d> seenAt(const Eigen::Vector3d& p_cam) const;
};

[[nodiscard]] CameraModel fromMrpt(const mrpt::img::TCamera& camera);
[[nodiscard]] mrpt::img::TCamera toMrpt(const CameraModel& camera);

template <class Self, class Visitor>
void CameraModel::describe(Self& self, Visitor& visit) {
  visit("width", self.width_px, {16, 16384}, "px", "image width");
  visit("height", self.height_px, {16, 16384}, "px", "image height");
  visit("fx", self.fx_px, {1.0, 1e5}, "px", "focal length, horizontal");
  visit("fy", self.fy_px, {1.0, 1e5}, "px", "focal length, vertical");
  visit("cx", self.cx_px, {-1e5, 1e5}, "px", "principal point, horizontal");
  visit("cy", self.cy_px, {-1e5, 1e5}, "px", "principal point, vertical");
  visit("k1", self.k1, {-100.0, 100.0}, "", "radial distortion");
  visit("k2", self.k2, {-100.0, 100.0}, "", "radial distortion");
  visit("p1", self.p1, {-10.0, 10.0}, "", "tangential distortion");
  visit("p2", self.p2, {-10.0, 10.0}, "", "tangential distortion");
  visit("k3", self.k3, {-1000.0, 1000.0}, "", "radial distortion");
  visit("readout", self.readout_s, {-0.05, 0.05}, "s",
        "rolling shutter: from the first row to the last, negative = from below; 0 = not known");
  visit.group("depth_noise", self.depthNoise);
}

}  // namespace wardslam::core
