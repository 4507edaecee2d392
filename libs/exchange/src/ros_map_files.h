#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::exchange {

/// The floor plan; throws core::InputError, naming `file`, where the map has none.
[[nodiscard]] const mapping::FloorPlan& floorPlanFor(const mapping::SemanticMap& map,
                                                     const std::filesystem::path& file);

/// A map of ROS map_server: `file` (YAML, with `rules` for what values mean) and a binary PGM beside it with the raster
/// of the plan. Its first row is the farthest along y.
void writeRosMap(const mapping::FloorPlan& plan, const std::function<unsigned char(int row, int column)>& valueAt,
                 const std::string& rules, const std::filesystem::path& file);

}  // namespace wardslam::exchange
