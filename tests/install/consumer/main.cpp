#include <wardslam/core/camera_model.h>
#include <wardslam/core/data_files.h>

#include <iostream>

/// usage: consumer PREFIX. Succeeds when the package works and its data comes from PREFIX, not from the source tree.
int main(int argc, char** argv) {
  const std::filesystem::path prefix = argc > 1 ? argv[1] : "";
  const auto knowledge = std::filesystem::canonical(wardslam::core::findDataFile("knowledge/hospital.yaml"));
  std::cout << "data file: " << knowledge << "\n";
  if (knowledge != std::filesystem::canonical(prefix) / "share/wardslam/config/knowledge/hospital.yaml") return 1;

  const wardslam::core::CameraModel camera;
  const auto pixel = camera.project({0.0, 0.0, 1.0});
  return pixel.x() == camera.cx_px && pixel.y() == camera.cy_px ? 0 : 1;
}
