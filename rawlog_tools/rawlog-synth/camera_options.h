#pragma once

#include <optional>

#include "camera_mount.h"
#include "wardslam/core/camera_model.h"

namespace wardslam::synth {

/// The camera as it is built and set up.
struct CameraOptions {
  double rate_hz = 30.0;
  int width_px = 640;
  int height_px = 480;
  std::optional<double> stereoBaseline_m;  ///< A second camera so far to the right instead of depth.
  CameraMount mount;
};

/// A camera with the Kinect's field of view.
[[nodiscard]] core::CameraModel cameraFor(int width_px, int height_px);

}  // namespace wardslam::synth
