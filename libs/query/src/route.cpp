#include "wardslam/query/route.h"

#include <algorithm>
#include <cmath>

#include "floor_ways.h"

namespace wardslam::query {
namespace {

/// Points at most `step_m` apart along the corners, without the first corner.
std::vector<Eigen::Vector2d> divided(const std::vector<Eigen::Vector2d>& corners_m, double step_m) {
  std::vector<Eigen::Vector2d> points_m;
  for (std::size_t i = 1; i < corners_m.size(); ++i) {
    const Eigen::Vector2d leg_m = corners_m[i] - corners_m[i - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(leg_m.norm() / step_m)));
    for (int part = 1; part <= parts; ++part) points_m.emplace_back(corners_m[i - 1] + leg_m * part / parts);
  }
  return points_m;
}

}  // namespace

std::optional<std::vector<Eigen::Vector2d>> planRoute(const DrivableFloor& floor, const Eigen::Vector2d& from_map_m,
                                                      const Eigen::Vector2d& to_map_m, double step_m, double reach_m) {
  const auto from_m = floor.nearestFree(from_map_m, reach_m);
  const auto to_m = floor.nearestFree(to_map_m, floor.plan().resolution_m);
  if (!from_m || !to_m) return std::nullopt;
  const FloorWays ways(floor.plan(), floor.plan().resolution_m);
  const auto start = ways.freeCellNear(*from_m, floor.plan().resolution_m);
  const auto goal = ways.freeCellNear(*to_m, floor.plan().resolution_m);
  if (!start || !goal) return std::nullopt;
  auto corners_m = ways.wayBetween(*start, *goal);
  if (!corners_m) return std::nullopt;

  corners_m->front() = *from_m;  // within the same cell
  corners_m->back() = *to_m;
  std::vector<Eigen::Vector2d> route_m;
  if (*from_m != from_map_m) route_m.push_back(*from_m);
  const auto points_m = corners_m->size() == 1 ? *corners_m : divided(*corners_m, step_m);
  route_m.insert(route_m.end(), points_m.begin(), points_m.end());
  return route_m;
}

double lengthOf_m(const Eigen::Vector2d& from_map_m, const std::vector<Eigen::Vector2d>& route_m) {
  double length_m = 0.0;
  Eigen::Vector2d last_m = from_map_m;
  for (const auto& point_m : route_m) {
    length_m += (point_m - last_m).norm();
    last_m = point_m;
  }
  return length_m;
}

}  // namespace wardslam::query
