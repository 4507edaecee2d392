#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace wardslam::mapping {

/// A named part of the floor (P11): a simple polygon in the map frame's x-y plane.
struct Zone {
  std::string name;
  std::vector<Eigen::Vector2d> polygon_m;  ///< At least 3 corners, not closed.
};

/// Whether the place lies in the zone; its border belongs to it.
[[nodiscard]] bool contains(const Zone& zone, const Eigen::Vector2d& p_map_m);

/// How far the place is from the zone; 0 within it.
[[nodiscard]] double distance_m(const Zone& zone, const Eigen::Vector2d& p_map_m);

[[nodiscard]] double area_m2(const Zone& zone);

}  // namespace wardslam::mapping
