#include "camera_format.h"
#include "camera_values.h"

namespace wardslam::sources {

/// NICE-SLAM and what came of it: a section "cam" with H, W and fx.
std::optional<RgbdCamera> readNiceSlamCamera(const core::ConfigNode& root) {
  if (!root.yaml().IsMap()) return std::nullopt;
  const core::ConfigNode section = root.child("cam");
  if (!section.exists() || !section.yaml().IsMap() || !section.child("fx").exists()) return std::nullopt;
  RgbdCamera camera;
  camera.color.width_px = pixelsAt(section, "W");
  camera.color.height_px = pixelsAt(section, "H");
  setPinhole(camera.color, section);
  const auto lens = section.child("distortion");
  if (lens.exists()) setPlumbBob(camera.color, numbersAt(lens, 0), lens);
  return camera;
}

}  // namespace wardslam::sources
