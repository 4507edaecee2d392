#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "simulated_robot.h"
#include "wardslam/mapping/semantic_map.h"
#include "wardslam/query/drivable_floor.h"

namespace wardslam::nav_demo {

constexpr double kReach_m = 0.6;  ///< From the robot's hull to what it delivers to.

/// What the robot is told.
struct Order {
  std::string target;                        ///< "bed 2"
  std::vector<std::string> forbidden;        ///< Names of zones of the map.
  std::optional<Eigen::Vector3d> start_map;  ///< x, y (m), yaw (rad); else where the map's last keyframe was taken.
};

/// What it makes of that with the map alone; map frame.
struct Mission {
  std::string name;       ///< Of the target, "bed 2".
  std::string className;  ///< "bed"
  const mapping::MapObject* object = nullptr;
  mapping::FloorPlan
      closedPlan;  ///< The map's, occupied where the robot must not go: in zones, and where nobody has been.
  std::vector<mapping::Zone> forbidden;
  query::DrivingRules rules;
  Eigen::Isometry2d T_map_start = Eigen::Isometry2d::Identity();
  query::Spot spot;
  std::vector<Eigen::Vector2d> route_m;
};

/// Throws core::InputError with the reason when nothing can be delivered: no such thing, no free spot beside it, no
/// way, or a forbidden zone around the goal or the start. The map must outlive the mission.
[[nodiscard]] Mission planMission(const mapping::SemanticMap& map, const Order& order, const RobotOptions& robot);

}  // namespace wardslam::nav_demo
