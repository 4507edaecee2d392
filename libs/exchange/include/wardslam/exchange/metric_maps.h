#pragma once

#include <memory>

#include "wardslam/mapping/semantic_map.h"

namespace mrpt::maps {
class CColouredPointsMap;
class COctoMap;
}  // namespace mrpt::maps

/// The map as MRPT's own metric maps; the floor plan is toOccupancyGrid().
namespace wardslam::exchange {

/// The cloud in its colours.
[[nodiscard]] std::shared_ptr<mrpt::maps::CColouredPointsMap> toColouredPoints(const mapping::SemanticMap& map);

/// Occupied, free and unknown as exportOctomap() has it.
[[nodiscard]] std::shared_ptr<mrpt::maps::COctoMap> toOctoMap(const mapping::SemanticMap& map,
                                                              double resolution_m = 0.05);

}  // namespace wardslam::exchange
