#include "mission.h"

#include <algorithm>
#include <opencv2/core.hpp>

#include "wardslam/core/errors.h"
#include "wardslam/core/nearest_name.h"
#include "wardslam/query/object_name.h"
#include "wardslam/query/route.h"

namespace wardslam::nav_demo {
namespace {

std::vector<mapping::Zone> zonesNamed(const std::vector<std::string>& names, const mapping::SemanticMap& map) {
  std::vector<mapping::Zone> zones;
  std::vector<std::string> known;
  for (const auto& zone : map.zones) known.push_back(zone.name);
  for (const auto& name : names) {
    const auto zone = std::find_if(map.zones.begin(), map.zones.end(), [&](const auto& z) { return z.name == name; });
    if (zone != map.zones.end()) {
      zones.push_back(*zone);
      continue;
    }
    if (known.empty())
      throw core::InputError("the map has no zones, so none called '" + name + "'; give some (--zones)");
    throw core::InputError("no zone is called '" + name + "'; did you mean '" + core::nearestName(name, known) + "'?");
  }
  return zones;
}

Eigen::Isometry2d startOf(const Order& order, const mapping::SemanticMap& map) {
  if (order.start_map)
    return Eigen::Translation2d(order.start_map->head<2>()) * Eigen::Rotation2Dd(order.start_map->z());
  if (map.keyframes.empty()) throw core::InputError("the map has no keyframes; say where the robot starts (--start)");
  const Eigen::Isometry3d& T_map_cam = map.keyframes.rbegin()->second.T_map_cam;
  const Eigen::Vector3d ahead = T_map_cam.linear().col(2);
  return Eigen::Translation2d(T_map_cam.translation().head<2>()) * Eigen::Rotation2Dd(std::atan2(ahead.y(), ahead.x()));
}

/// What the order forbids, and what the zones themselves do.
std::vector<mapping::Zone> forbiddenBy(const Order& order, const mapping::SemanticMap& map) {
  std::vector<mapping::Zone> zones = zonesNamed(order.forbidden, map);
  for (mapping::Zone& zone : mapping::zonesOfType(map.zones, mapping::ZoneType::Forbidden)) {
    const auto isIt = [&zone](const mapping::Zone& other) { return other.name == zone.name; };
    if (std::none_of(zones.begin(), zones.end(), isIt)) zones.push_back(std::move(zone));
  }
  return zones;
}

std::string listOf(const std::vector<mapping::Zone>& zones) {
  std::string list;
  for (const auto& zone : zones) list += (list.empty() ? "'" : ", '") + zone.name + "'";
  return list;
}

/// Why there is no spot beside the object with a way to it.
std::string reasonFor(const Mission& mission, const mapping::FloorPlan& plan, const Eigen::Vector2d& start_m) {
  const query::DrivingRules free{mission.rules.radius_m, {}, false};
  const query::DrivableFloor anywhere(plan, free);
  const query::DrivableFloor allowed(plan, mission.rules);
  if (!anywhere.nearestFree(start_m, mission.rules.radius_m))
    return "the robot does not start on free floor of the map";
  if (!anywhere.spotBeside(*mission.object, kReach_m))
    return "there is no free spot beside " + mission.name + " on the map";
  if (!anywhere.spotBeside(*mission.object, kReach_m, start_m))
    return "no way leads from the robot to a spot beside " + mission.name;
  const std::string zones = (mission.forbidden.size() == 1 ? "zone " : "zones ") + listOf(mission.forbidden);
  if (!allowed.nearestFree(start_m, mission.rules.radius_m)) return "the robot starts within forbidden " + zones;
  if (!allowed.spotBeside(*mission.object, kReach_m))
    return "forbidden " + zones + " leaves no spot beside " + mission.name;
  return "forbidden " + zones + " cuts off all ways to " + mission.name;
}

}  // namespace

Mission planMission(const mapping::SemanticMap& map, const Order& order, const RobotOptions& robot) {
  if (map.floorPlan.cells.empty()) throw core::InputError("the map has no floor plan to drive by");
  Mission mission;
  mission.object = &query::objectNamed(map, order.target);
  mission.name = query::nameOf(*mission.object, map);
  mission.className = map.labels.name(mission.object->classId);
  mission.forbidden = forbiddenBy(order, map);
  mission.closedPlan = query::closeZones(map.floorPlan, mission.forbidden);
  mission.closedPlan.cells.setTo(mapping::FloorPlan::kOccupied,
                                 mission.closedPlan.cells == mapping::FloorPlan::kUnknown);
  mission.rules = {robot.radius_m + robot.margin_m, mission.forbidden, false};
  mission.T_map_start = startOf(order, map);

  const Eigen::Vector2d start_m = mission.T_map_start.translation();
  const query::DrivableFloor floor(map.floorPlan, mission.rules);
  const auto spot = floor.spotBeside(*mission.object, kReach_m, start_m);
  const auto route = spot ? query::planRoute(floor, start_m, spot->p_map_m) : std::nullopt;
  if (!route) throw core::InputError(reasonFor(mission, map.floorPlan, start_m));
  mission.spot = *spot;
  mission.route_m = *route;
  return mission;
}

}  // namespace wardslam::nav_demo
