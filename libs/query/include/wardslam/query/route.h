#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "wardslam/query/drivable_floor.h"

namespace wardslam::query {

/// A short way over the floor for the robot's middle: points at most `step_m` apart, the goal last, the start left out.
/// Start and goal are moved onto drivable floor, at most `reach_m` (at the start) and one cell (at the goal). Nothing
/// where no way leads.
[[nodiscard]] std::optional<std::vector<Eigen::Vector2d>> planRoute(const DrivableFloor& floor,
                                                                    const Eigen::Vector2d& from_map_m,
                                                                    const Eigen::Vector2d& to_map_m,
                                                                    double step_m = 0.4, double reach_m = 0.5);

/// Its length from the start over all points.
[[nodiscard]] double lengthOf_m(const Eigen::Vector2d& from_map_m, const std::vector<Eigen::Vector2d>& route_m);

}  // namespace wardslam::query
