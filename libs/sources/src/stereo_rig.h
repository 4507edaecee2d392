#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "wardslam/core/camera_model.h"

namespace mrpt::obs {
class CObservationStereoImages;
}

namespace wardslam::sources {

/// Two cameras side by side, as they are once their images are rectified: rows of one are rows of the other, and what
/// is z_m away is f b / z + `disparityOfInfinity_px` farther to the left in the right image.
struct StereoRig {
  core::CameraModel camera;  ///< The left one; no distortion.
  double baseline_m = 0.0;
  double disparityOfInfinity_px = 0.0;
  Eigen::Matrix3d R_left_rectified = Eigen::Matrix3d::Identity();

  /// For cv::remap, CV_32FC1: where in the recorded image (x, y) a rectified pixel lies. Empty: recorded rectified.
  struct Maps {
    cv::Mat x;
    cv::Mat y;
  };
  Maps left;
  Maps right;

  [[nodiscard]] double disparityAt_px(double z_m) const {
    return camera.fx_px * baseline_m / z_m + disparityOfInfinity_px;
  }
};

/// The cameras of a pair that whyUnusable() finds nothing wrong with. Throws core::FrameError where they do not stand
/// side by side, the right one on the right.
[[nodiscard]] StereoRig rigOf(const mrpt::obs::CObservationStereoImages& pair);

}  // namespace wardslam::sources
