#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "true_world.h"

namespace wardslam::nav_demo {

/// What the robot sees with: distances in a plane, as a laser has them, or a depth camera after convertTo2DScan().
struct ScannerOptions {
  double range_m = 4.0;
  double fieldOfView_rad = 4.19;  ///< 240 degrees, as far to the left as to the right.
  int rays = 241;
};

/// End points of the rays that met something, robot frame, m.
[[nodiscard]] std::vector<Eigen::Vector2d> scan(const TrueWorld& world, const std::vector<Disc>& people,
                                                const Eigen::Isometry2d& T_world_robot, const ScannerOptions& options);

}  // namespace wardslam::nav_demo
