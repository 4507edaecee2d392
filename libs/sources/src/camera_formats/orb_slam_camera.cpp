#include "camera_format.h"
#include "camera_values.h"

namespace wardslam::sources {

/// ORB-SLAM2 and what came of it ("Camera.fx"), ORB-SLAM3 ("Camera1.fx"), OpenVSLAM ("Camera.cols").
std::optional<RgbdCamera> readOrbSlamCamera(const core::ConfigNode& root) {
  if (!root.yaml().IsMap()) return std::nullopt;
  const bool isThird = root.child("Camera1.fx").exists();
  if (!isThird && !root.child("Camera.fx").exists()) return std::nullopt;
  const std::string prefix = isThird ? "Camera1." : "Camera.";
  requirePlumbBob(firstChild(root, {"Camera.type", "Camera.model"}));
  RgbdCamera camera;
  camera.color.fx_px = numberAt(root, prefix + "fx");
  camera.color.fy_px = numberAt(root, prefix + "fy");
  camera.color.cx_px = numberAt(root, prefix + "cx");
  camera.color.cy_px = numberAt(root, prefix + "cy");
  camera.color.k1 = numberAt(root, prefix + "k1", 0.0);
  camera.color.k2 = numberAt(root, prefix + "k2", 0.0);
  camera.color.p1 = numberAt(root, prefix + "p1", 0.0);
  camera.color.p2 = numberAt(root, prefix + "p2", 0.0);
  camera.color.k3 = numberAt(root, prefix + "k3", 0.0);
  camera.color.width_px = pixelsIn(numberAt(root, "Camera.width", numberAt(root, "Camera.cols", 0.0)), root);
  camera.color.height_px = pixelsIn(numberAt(root, "Camera.height", numberAt(root, "Camera.rows", 0.0)), root);
  camera.rate_hz = numberAt(root, "Camera.fps", camera.rate_hz);
  return camera;
}

}  // namespace wardslam::sources
