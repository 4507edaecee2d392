#pragma once

#include <string>
#include <vector>

#include "camera/camera_mount.h"
#include "hospital/hospital_options.h"
#include "scene/setting.h"

namespace wardslam::synth {

/// Which place is rendered, and what it holds.
struct PlaceOptions {
  std::string name = "ward";  ///< One of places().
  SceneOptions scene;
  HospitalOptions hospital;
};

struct Place {
  std::string name;
  std::string description;
  Setting (*build)(const PlaceOptions& options, const CameraMount& mount);
};

/// All places there are; a new one is one line here.
[[nodiscard]] const std::vector<Place>& places();

/// Throws core::InputError when there is no such place.
[[nodiscard]] Setting buildPlace(const PlaceOptions& options, const CameraMount& mount);

}  // namespace wardslam::synth
