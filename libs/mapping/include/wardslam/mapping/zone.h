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

}  // namespace wardslam::mapping
