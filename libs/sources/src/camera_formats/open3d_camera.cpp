#include "camera_format.h"
#include "camera_values.h"

namespace wardslam::sources {

/// Open3D's PinholeCameraIntrinsic (JSON): intrinsic_matrix column by column.
std::optional<RgbdCamera> readOpen3dCamera(const core::ConfigNode& root) {
  if (!root.yaml().IsMap()) return std::nullopt;
  const auto matrix = root.child("intrinsic_matrix");
  if (!matrix.exists() || !matrix.yaml().IsSequence()) return std::nullopt;
  const auto columns = numbersAt(matrix, 9);
  RgbdCamera camera;
  camera.color.width_px = pixelsAt(root, "width");
  camera.color.height_px = pixelsAt(root, "height");
  camera.color.fx_px = columns[0];
  camera.color.fy_px = columns[4];
  camera.color.cx_px = columns[6];
  camera.color.cy_px = columns[7];
  return camera;
}

}  // namespace wardslam::sources
