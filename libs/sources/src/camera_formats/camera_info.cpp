#include "camera_format.h"
#include "camera_values.h"

namespace wardslam::sources {

/// A sensor_msgs/CameraInfo as `rostopic echo` (K, D) and `ros2 topic echo` (k, d) print it.
std::optional<RgbdCamera> readCameraInfo(const core::ConfigNode& root) {
  if (!root.yaml().IsMap()) return std::nullopt;
  const auto matrix = firstChild(root, {"K", "k"});
  if (!matrix.exists() || !matrix.yaml().IsSequence()) return std::nullopt;
  requirePlumbBob(root.child("distortion_model"));
  RgbdCamera camera;
  camera.color.width_px = pixelsAt(root, "width");
  camera.color.height_px = pixelsAt(root, "height");
  setMatrix(camera.color, numbersAt(matrix, 9));
  const auto lens = firstChild(root, {"D", "d"});
  if (lens.exists()) setPlumbBob(camera.color, numbersAt(lens, 0), lens);
  return camera;
}

}  // namespace wardslam::sources
