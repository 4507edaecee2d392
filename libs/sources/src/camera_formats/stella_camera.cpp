#include "camera_format.h"
#include "camera_values.h"

namespace wardslam::sources {

/// stella_vslam: a section "Camera" with fx, cols and rows.
std::optional<RgbdCamera> readStellaCamera(const core::ConfigNode& root) {
  if (!root.yaml().IsMap()) return std::nullopt;
  const core::ConfigNode section = root.child("Camera");
  if (!section.exists() || !section.yaml().IsMap() || !section.child("fx").exists()) return std::nullopt;
  requirePlumbBob(section.child("model"));
  RgbdCamera camera;
  camera.color.width_px = pixelsAt(section, "cols");
  camera.color.height_px = pixelsAt(section, "rows");
  setPinhole(camera.color, section);
  camera.color.k1 = numberAt(section, "k1", 0.0);
  camera.color.k2 = numberAt(section, "k2", 0.0);
  camera.color.p1 = numberAt(section, "p1", 0.0);
  camera.color.p2 = numberAt(section, "p2", 0.0);
  camera.color.k3 = numberAt(section, "k3", 0.0);
  camera.rate_hz = numberAt(section, "fps", camera.rate_hz);
  return camera;
}

}  // namespace wardslam::sources
