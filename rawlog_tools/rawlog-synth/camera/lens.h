#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "camera/directions.h"
#include "wardslam/core/camera_model.h"

namespace wardslam::synth {

/// None: an ideal pinhole. Kinect: the plumb-bob coefficients of the colour camera of a real one (TUM freiburg1, as in
/// config/cameras). Wide: a strong barrel, k1 = -0.28; k2 = 0.07 as such lenses have it, as without it the model folds
/// back within the image.
enum class Lens { None, Kinect, Wide };

[[nodiscard]] core::CameraModel withLens(core::CameraModel camera, Lens lens);

/// Where the light of each pixel comes from, through the camera's lens.
class LensView {
 public:
  /// Throws core::InputError where the lens model reaches no farther than a part of the image.
  LensView(const core::CameraModel& camera = {});  // NOLINT(google-explicit-constructor): a camera has its lens

  /// A pinhole camera of the same focal length whose image holds all that the lens shows; without distortion the camera
  /// itself.
  [[nodiscard]] const core::CameraModel& pinhole() const { return pinhole_; }

  /// The ray of a pixel, camera frame, z = 1.
  [[nodiscard]] Eigen::Vector3d ray(int x_px, int y_px) const {
    const auto& ray = rays_.at<cv::Vec3d>(y_px, x_px);
    return {ray[0], ray[1], ray[2]};
  }
  /// Those of the pixels of an image of that size in which the same is seen.
  [[nodiscard]] Directions rays(const cv::Size& size_px) const;

 private:
  core::CameraModel camera_;
  core::CameraModel pinhole_;
  cv::Mat rays_;  ///< CV_64FC3
};

}  // namespace wardslam::synth
