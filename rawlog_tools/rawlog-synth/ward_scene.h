#pragma once

#include <cstdint>

#include "scene.h"

namespace wardslam::synth {

struct WardOptions {
  std::uint32_t seed = 1;  ///< Textures, and small differences in how the furniture stands.
  bool people = true;      ///< Without them the trolley stands where they would have left it.
};

/// A ward of one room: five beds along two walls, an aisle between them in which a CameraPath finds its way, a nurse
/// who passes close by, a porter who brings a trolley and leaves it standing, a visitor.
[[nodiscard]] Scene buildWard(const WardOptions& options);

/// When the porter lets go of the trolley.
constexpr double kTrolleyLeft_s = 5.8;

}  // namespace wardslam::synth
