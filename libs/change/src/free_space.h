#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "evidence.h"
#include "wardslam/core/camera_model.h"

namespace wardslam::change {

/// A depth image at a quarter of the size, made to be compared with others.
class DepthGrid {
 public:
  static constexpr int kStep_px = 4;

  DepthGrid() = default;
  /// `depth_m`: CV_32FC1, raw pixels, 0 = none. What follows from the camera alone is shared with the grid of the
  /// image before, if it is given and of the same camera.
  DepthGrid(const cv::Mat& depth_m, const core::CameraModel& camera, const DepthGrid* before = nullptr);

  [[nodiscard]] cv::Size size() const { return depth_m_.size(); }
  [[nodiscard]] const cv::Mat& depth_m() const { return depth_m_; }  ///< CV_32FC1, of size().

  /// For each pixel of this grid, what the past one says about the surface there: Seen (CV_8UC1). `T_past_this` takes
  /// points of this camera to the past one.
  [[nodiscard]] cv::Mat compareWith(const DepthGrid& past, const Eigen::Isometry3d& T_past_this) const;

 private:
  /// `p_m`: a point of another view, in the frame of this camera.
  [[nodiscard]] Seen look(const Eigen::Vector3d& p_m, const core::DepthNoise& ofPoint) const;

  core::CameraModel camera_;
  cv::Mat depth_m_;
  cv::Mat nearest_m_;   ///< Smallest depth within two pixels: what a small error of the pose could show instead.
  cv::Mat farthest_m_;  ///< Largest.
  cv::Mat rays_;        ///< CV_32FC2: x/z and y/z of each pixel.
};

}  // namespace wardslam::change
