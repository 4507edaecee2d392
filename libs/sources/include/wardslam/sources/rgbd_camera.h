#pragma once

#include <filesystem>
#include <string>

#include "wardslam/core/camera_model.h"

namespace wardslam::sources {

/// What a camera file says (config/cameras/, or camera.yaml in a recording's folder): the colour camera, to which the
/// depth images are registered, and the unit of the depth images.
struct RgbdCamera {
  core::CameraModel color;
  double depth_units_per_m = 5000.0;  ///< Of 16-bit depth images in files; rawlogs carry their own unit.
  double rate_hz = 30.0;              ///< Nominal; for information.

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit);
};

/// Throws core::InputError naming file, line and key. Size, focal lengths and principal point must be there: a
/// default would silently be another camera.
[[nodiscard]] RgbdCamera readRgbdCamera(const std::filesystem::path& file);

/// The camera files that come with the program, one sentence part: "<folder>/tum_freiburg1.yaml, …".
[[nodiscard]] std::string listCameraFiles();

template <class Self, class Visitor>
void RgbdCamera::describe(Self& self, Visitor& visit) {
  core::CameraModel::describe(self.color, visit);
  visit("depth_factor", self.depth_units_per_m, {1.0, 1e6}, "units/m", "value of a depth pixel one metre away");
  visit("fps", self.rate_hz, {0.1, 1000.0}, "Hz", "nominal frame rate, for information");
}

}  // namespace wardslam::sources
