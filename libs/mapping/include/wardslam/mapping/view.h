#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "wardslam/core/camera_model.h"
#include "wardslam/core/segmentation.h"
#include "wardslam/odometry/keyframe.h"

namespace wardslam::mapping {

/// An RGB-D image to be worked into the map. Images as in core::Frame; those of the masks may be empty.
struct View {
  odometry::KeyframeId keyframe = 0;  ///< The one it hangs on; moves with it.
  bool isKeyframe = false;            ///< It is the image of that keyframe itself.
  Eigen::Isometry3d T_keyframe_cam = Eigen::Isometry3d::Identity();
  double stamp_s = 0.0;
  core::CameraModel camera;
  cv::Mat color_bgr;
  cv::Mat depth_m;
  core::Segmentation segmentation;
  cv::Mat mayMove;
};

}  // namespace wardslam::mapping
