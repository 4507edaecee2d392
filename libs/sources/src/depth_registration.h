#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "wardslam/core/camera_model.h"

namespace wardslam::sources {

/// A depth camera mounted beside a colour camera.
struct RgbdRig {
  core::CameraModel depth;
  core::CameraModel color;
  Eigen::Isometry3d T_color_depth = Eigen::Isometry3d::Identity();  ///< Between the optical frames.
};

/// Redraws depth images as the colour camera would have seen them. Each depth pixel is a small square in space; where
/// several fall on one colour pixel the nearest wins, so that the background does not shine through.
class DepthRegistration {
 public:
  explicit DepthRegistration(const RgbdRig& rig);

  /// `depth_m`: CV_32FC1 of the depth camera's size, metres along its axis, 0 = none. Returns CV_32FC1 of the colour
  /// camera's size, metres along that camera's axis, 0 = none.
  [[nodiscard]] cv::Mat apply(const cv::Mat& depth_m) const;

 private:
  void splat(const Eigen::Vector3d& p_color, double halfWidth_px, cv::Mat& registered_m) const;

  RgbdRig rig_;
  cv::Mat depthRays_;
};

}  // namespace wardslam::sources
