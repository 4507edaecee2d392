#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <opencv2/core.hpp>

#include "wardslam/core/camera_model.h"

namespace wardslam::change {

/// What an earlier depth image says about a pixel of the current one.
enum class Space : std::uint8_t {
  Unknown = 0,   ///< Out of its view, hidden in it, or without depth in either.
  Same = 1,      ///< It saw a surface there.
  Appeared = 2,  ///< It saw through the place where now is a surface: that surface has come.
};

/// A depth image at a quarter of the size, made to be compared with others.
class SpaceView {
 public:
  static constexpr int kStep_px = 4;

  SpaceView() = default;
  /// `depth_m`: CV_32FC1, raw pixels, 0 = none. What follows from the camera alone is shared with the view of the
  /// image before, if it is given and of the same camera.
  SpaceView(const cv::Mat& depth_m, const core::CameraModel& camera, const SpaceView* before = nullptr);

  [[nodiscard]] cv::Size size() const { return depth_m_.size(); }
  [[nodiscard]] const cv::Mat& depth_m() const { return depth_m_; }  ///< CV_32FC1, of size().

  /// For each pixel of this view a Space (CV_8UC1). `T_past_this` takes points of this camera to the past one.
  /// `margin`: how many standard deviations of the two depths (and on top 4 cm) make a difference.
  [[nodiscard]] cv::Mat compareWith(const SpaceView& past, const Eigen::Isometry3d& T_past_this,
                                    double margin = 4.0) const;

 private:
  [[nodiscard]] Space compare(const Eigen::Vector3d& p_past_m, const SpaceView& past, double margin) const;

  core::CameraModel camera_;
  cv::Mat depth_m_;
  cv::Mat nearest_m_;   ///< Smallest depth within two pixels: what a small error of the pose could show instead.
  cv::Mat farthest_m_;  ///< Largest.
  cv::Mat rays_;        ///< CV_32FC2: x/z and y/z of each pixel.
};

}  // namespace wardslam::change
