#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "wardslam/core/camera_model.h"

namespace wardslam::sources {

/// What a camera file says (config/cameras/, or camera.yaml in a recording's folder): the colour camera, to which the
/// depth images are registered, and the unit of the depth images.
struct RgbdCamera {
  core::CameraModel color;
  double depth_units_per_m = 0.0;  ///< Of 16-bit depth images in files; 0: not told. Rawlogs carry their own unit.
  double rate_hz = 30.0;           ///< Nominal; for information.

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit);
};

/// Reads our own camera files and those of the programs in docs/inputs.md. Size, focal lengths and principal point must
/// be there: a default would silently be another camera. `note` hears, in a sentence each, as what a foreign file was
/// read and what is odd about the numbers. Where ORB-SLAM's file does not tell the size of the images it is 0x0. Throws
/// core::InputError naming file, line and key; also for a principal point outside the image.
[[nodiscard]] RgbdCamera readRgbdCamera(
    const std::filesystem::path& file, const std::function<void(const std::string&)>& note = [](const std::string&) {});

/// The camera files that come with the program, one sentence part: "<folder>/tum_freiburg1.yaml, …".
[[nodiscard]] std::string listCameraFiles();

template <class Self, class Visitor>
void RgbdCamera::describe(Self& self, Visitor& visit) {
  core::CameraModel::describe(self.color, visit);
  visit("depth_factor", self.depth_units_per_m, {1.0, 1e6}, "units/m", "value of a depth pixel one metre away");
  visit("fps", self.rate_hz, {0.1, 1000.0}, "Hz", "nominal frame rate, for information");
}

}  // namespace wardslam::sources
