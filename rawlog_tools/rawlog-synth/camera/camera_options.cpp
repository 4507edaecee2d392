#include "camera/camera_options.h"

namespace wardslam::synth {

core::CameraModel cameraFor(int width_px, int height_px) {
  core::CameraModel camera;
  camera.width_px = width_px;
  camera.height_px = height_px;
  camera.fx_px = camera.fy_px = 525.0 * width_px / 640.0;
  camera.cx_px = (width_px - 1) / 2.0;
  camera.cy_px = (height_px - 1) / 2.0;
  return camera;
}

core::CameraModel modelOf(const CameraOptions& options) {
  return withLens(cameraFor(options.width_px, options.height_px), options.lens);
}

Eigen::Isometry3d statedMount(const CameraOptions& options) {
  return T_base_sensor(options.isMountStated ? options.mount : CameraMount{options.mount.height_m, 0.0, 0.0});
}

}  // namespace wardslam::synth
