#pragma once

#include "wardslam/mapping/floor_plan.h"

namespace mrpt::maps {
class COccupancyGridMap2D;
}

namespace wardslam::exchange {

/// The plan as MRPT's planners take it: 1 = free, 0 = occupied, 0.5 = unknown, in the map frame.
[[nodiscard]] mrpt::maps::COccupancyGridMap2D toOccupancyGrid(const mapping::FloorPlan& plan);

}  // namespace wardslam::exchange
