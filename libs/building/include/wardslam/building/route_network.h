#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace wardslam::building {

/// A place that ways lead to, or at which one bends.
struct Waypoint {
  std::string name;  ///< "ward 3", "ward 3 to corridor" of a door; empty at a bend. No two are called the same.
  Eigen::Vector2d p_map_m = Eigen::Vector2d::Zero();
};

/// A straight way, to be gone in one direction.
struct Lane {
  std::size_t from = 0;       ///< Index of its waypoint.
  std::size_t to = 0;         ///< Likewise.
  double maxSpeed_mps = 0.0;  ///< 0: no zone limits it.
};

/// Ways that a fleet may send robots along: from the middle of each room to its doors, and between them.
struct RouteNetwork {
  std::vector<Waypoint> waypoints;
  std::vector<Lane> lanes;
};

}  // namespace wardslam::building
