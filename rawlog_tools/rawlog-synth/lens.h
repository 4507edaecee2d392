#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "wardslam/core/camera_model.h"

namespace wardslam::synth {

/// None: an ideal pinhole. Kinect: the plumb-bob coefficients of the colour camera of a real one (TUM freiburg1, as in
/// config/cameras). Wide: a strong barrel, k1 = -0.28; k2 = 0.07 as such lenses have it, as without it the model folds
/// back within the image.
enum class Lens { None, Kinect, Wide };

[[nodiscard]] core::CameraModel withLens(core::CameraModel camera, Lens lens);

/// How what a distorting lens shows is made from an ideal pinhole's view: every pixel is looked up where the inverse
/// lens model says.
class LensView {
 public:
  /// Throws core::InputError where the lens model reaches no farther than a part of the image.
  LensView(const core::CameraModel& camera = {});  // NOLINT(google-explicit-constructor): a camera has its lens

  /// A pinhole camera of the same focal length whose image holds all that the lens shows; without distortion the camera
  /// itself.
  [[nodiscard]] const core::CameraModel& pinhole() const { return pinhole_; }
  [[nodiscard]] bool isIdeal() const { return where_px_.empty(); }

  /// Images of the pinhole's size in, of the camera's out: colours bilinearly, anything else (depth, numbers) from the
  /// nearest pixel; there the image may be a whole number of times larger, and so hold nearer ones.
  [[nodiscard]] cv::Mat colours(const cv::Mat& ofPinhole) const;
  [[nodiscard]] cv::Mat nearest(const cv::Mat& ofPinhole) const;

  /// The ray of a pixel of the distorted image, camera frame, z = 1.
  [[nodiscard]] Eigen::Vector3d ray(int x_px, int y_px) const;

 private:
  core::CameraModel pinhole_;
  cv::Mat where_px_;  ///< CV_32FC2 of the camera's size: the pinhole's pixel; empty where nothing is distorted.
};

}  // namespace wardslam::synth
