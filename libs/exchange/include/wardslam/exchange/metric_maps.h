#pragma once

#include <memory>

#include "wardslam/mapping/semantic_map.h"

namespace mrpt::maps {
class CColouredOctoMap;
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

/// The same, and occupied voxels have the mean colour of the cloud's points in them.
[[nodiscard]] std::shared_ptr<mrpt::maps::CColouredOctoMap> toColouredOctoMap(const mapping::SemanticMap& map,
                                                                              double resolution_m = 0.05);

}  // namespace wardslam::exchange
