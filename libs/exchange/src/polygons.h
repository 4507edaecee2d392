#pragma once

#include <Eigen/Core>
#include <vector>

#include "wardslam/mapping/map_object.h"

namespace wardslam::exchange {

/// The corners counter-clockwise, as outer rings are wanted, and the first once more at the end.
[[nodiscard]] std::vector<Eigen::Vector2d> closedRing(std::vector<Eigen::Vector2d> corners_m);

/// What an object covers of the floor: its box parallel to the axes of the map frame.
[[nodiscard]] std::vector<Eigen::Vector2d> footprintOf(const mapping::MapObject& object);

}  // namespace wardslam::exchange
