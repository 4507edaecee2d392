#pragma once

#include <filesystem>

#include "wardslam/mapping/floor_plan.h"

namespace wardslam::exchange {

/// A map of ROS map_server (YAML with an image beside it) as a floor plan in the frame of that map. Throws
/// core::InputError where it cannot be read, or lies turned in its frame.
[[nodiscard]] mapping::FloorPlan readRosMap(const std::filesystem::path& file);

}  // namespace wardslam::exchange
