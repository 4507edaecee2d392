#include "camera_format.h"
#include "camera_values.h"

namespace wardslam::sources {
namespace {

void setSize(core::CameraModel& camera, const core::ConfigNode& root) {
  const auto size = firstChild(root, {"image_size", "imageSize", "ImageSize"});
  if (size.exists()) {
    const auto numbers = numbersAt(size.yaml().IsMap() ? size.child("data") : size, 2);
    camera.width_px = pixelsIn(numbers[0], size);
    camera.height_px = pixelsIn(numbers[1], size);
    return;
  }
  for (const auto& [width, height] :
       {std::pair("image_width", "image_height"), std::pair("image_Width", "image_Height"),
        std::pair("imageWidth", "imageHeight"), std::pair("width", "height")}) {
    if (!root.child(width).exists()) continue;
    camera.width_px = pixelsAt(root, width);
    camera.height_px = pixelsAt(root, height);
    return;
  }
}

}  // namespace

/// camera_calibration and camera_info_manager of ROS, and OpenCV's FileStorage: matrices with rows, cols and data.
std::optional<RgbdCamera> readCameraMatrix(const core::ConfigNode& root) {
  if (!root.yaml().IsMap()) return std::nullopt;
  const auto matrix = firstChild(root, {"camera_matrix", "Camera_Matrix", "cameraMatrix", "CameraMatrix",
                                        "intrinsic_matrix", "intrinsics", "K", "M", "M1"});
  if (!matrix.exists() || !matrix.yaml().IsMap() || !matrix.child("data").exists()) return std::nullopt;
  requirePlumbBob(root.child("distortion_model"));
  RgbdCamera camera;
  camera.color.width_px = camera.color.height_px = 0;
  setSize(camera.color, root);
  setMatrix(camera.color, numbersAt(matrix.child("data"), 9));
  const auto lens = firstChild(root, {"distortion_coefficients", "Distortion_Coefficients", "distCoeffs", "dist_coeffs",
                                      "distortion", "D", "D1"});
  if (lens.exists()) setPlumbBob(camera.color, numbersAt(lens.yaml().IsMap() ? lens.child("data") : lens, 0), lens);
  return camera;
}

}  // namespace wardslam::sources
