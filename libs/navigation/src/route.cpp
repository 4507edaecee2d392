#include "wardslam/navigation/route.h"

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/nav/planners/PlannerSimple2D.h>

#include <deque>

#include "wardslam/exchange/occupancy_grid.h"

namespace wardslam::navigation {
namespace {

mrpt::poses::CPose2D toPose(const Eigen::Vector2d& p_m) { return {p_m.x(), p_m.y(), 0.0}; }

}  // namespace

std::optional<std::vector<Eigen::Vector2d>> planRoute(const query::DrivableFloor& floor,
                                                      const Eigen::Vector2d& from_map_m,
                                                      const Eigen::Vector2d& to_map_m, double step_m, double reach_m) {
  const auto from = floor.nearestFree(from_map_m, reach_m);
  const auto to = floor.nearestFree(to_map_m, floor.plan().resolution_m);
  if (!from || !to) return std::nullopt;

  mrpt::nav::PlannerSimple2D planner;
  planner.robotRadius = 0.0F;  // the drivable floor keeps the radius already
  planner.minStepInReturnedPath = static_cast<float>(step_m);
  std::deque<mrpt::math::TPoint2D> path;
  bool notFound = false;
  planner.computePath(exchange::toOccupancyGrid(floor.plan()), toPose(*from), toPose(*to), path, notFound);
  if (notFound) return std::nullopt;

  std::vector<Eigen::Vector2d> route_m;
  if (*from != from_map_m) route_m.push_back(*from);
  for (const auto& point : path) route_m.emplace_back(point.x, point.y);
  return route_m;
}

double lengthOf_m(const Eigen::Vector2d& from_map_m, const std::vector<Eigen::Vector2d>& route_m) {
  double length_m = 0.0;
  Eigen::Vector2d last = from_map_m;
  for (const auto& point : route_m) {
    length_m += (point - last).norm();
    last = point;
  }
  return length_m;
}

}  // namespace wardslam::navigation
