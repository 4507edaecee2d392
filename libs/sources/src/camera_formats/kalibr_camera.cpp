#include "camera_format.h"
#include "camera_values.h"

namespace wardslam::sources {

/// Kalibr's camchain: cam0 with intrinsics [fx, fy, cx, cy] and resolution [width, height].
std::optional<RgbdCamera> readKalibrCamera(const core::ConfigNode& root) {
  if (!root.yaml().IsMap()) return std::nullopt;
  const core::ConfigNode section = root.child("cam0");
  if (!section.exists() || !section.yaml().IsMap()) return std::nullopt;
  if (root.child("cam1").exists()) {
    root.fail("holds several cameras; leave that of the colour images, as cam0");
  }
  requirePlumbBob(section.child("camera_model"));
  requirePlumbBob(section.child("distortion_model"));
  const auto intrinsics = numbersAt(section.child("intrinsics"), 4);
  const auto resolution = numbersAt(section.child("resolution"), 2);
  RgbdCamera camera;
  camera.color.width_px = pixelsIn(resolution[0], section);
  camera.color.height_px = pixelsIn(resolution[1], section);
  camera.color.fx_px = intrinsics[0];
  camera.color.fy_px = intrinsics[1];
  camera.color.cx_px = intrinsics[2];
  camera.color.cy_px = intrinsics[3];
  const auto lens = section.child("distortion_coeffs");
  if (lens.exists()) setPlumbBob(camera.color, numbersAt(lens, 0), lens);
  return camera;
}

}  // namespace wardslam::sources
