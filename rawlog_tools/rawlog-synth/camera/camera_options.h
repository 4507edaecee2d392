#pragma once

#include <optional>

#include "camera/camera_mount.h"
#include "camera/lens.h"
#include "wardslam/core/camera_model.h"

namespace wardslam::synth {

/// The camera as it is built and set up.
struct CameraOptions {
  double rate_hz = 30.0;
  int width_px = 640;
  int height_px = 480;
  Lens lens = Lens::None;
  std::optional<double> stereoBaseline_m;  ///< A second camera so far to the right instead of depth.
  CameraMount mount;
  bool isMountStated = false;  ///< The recording says how the camera is mounted; else 1.1 m high and level.
};

/// A camera with the Kinect's field of view.
[[nodiscard]] core::CameraModel cameraFor(int width_px, int height_px);
/// The same with its lens.
[[nodiscard]] core::CameraModel modelOf(const CameraOptions& options);

/// What the recording says of where the sensor (x forward, y left, z up) sits on the base.
[[nodiscard]] Eigen::Isometry3d statedMount(const CameraOptions& options);

}  // namespace wardslam::synth
