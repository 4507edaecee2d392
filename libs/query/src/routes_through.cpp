#include "wardslam/query/routes_through.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>

#include "floor_ways.h"
#include "wardslam/query/route.h"

namespace wardslam::query {
namespace {

using building::Door;
using building::Lane;
using building::Room;
using building::Rooms;
using building::RouteNetwork;

constexpr double kMiddleReach_m = 1.0;  // something may stand in the middle of a room,
constexpr double kDoorReach_m = 0.4;    // and a door may stand ajar
constexpr double kDoorway_m = 0.8;      // around a door, the floor belongs to either room
constexpr double kSampling_m = 0.1;     // of a lane, for the zones it leads through

/// One end of ways within a room.
struct Terminal {
  std::size_t waypoint = 0;
  Eigen::Vector2d p_map_m = Eigen::Vector2d::Zero();
};

/// Ways between terminals: corners by the indices of both, the smaller first.
using Ways = std::map<std::pair<std::size_t, std::size_t>, std::vector<Eigen::Vector2d>>;

std::string nameOf(const Door& door, const Rooms& rooms) {
  const auto room = [&rooms](int id) { return rooms.all.at(static_cast<std::size_t>(id - 1)).name; };
  return room(door.room) + " to " + room(door.other);
}

/// What of the plan a robot may use within one room and its doorways; the rest is occupied.
mapping::FloorPlan floorOf(const Room& room, const std::vector<const Door*>& doors, const Rooms& rooms,
                           const mapping::FloorPlan& plan) {
  cv::Mat isOfRoom = rooms.ids == room.id;
  for (const Door* door : doors) {
    const Eigen::Vector2d cell = (door->middle_m() - plan.origin_m) / plan.resolution_m;
    const int reach = static_cast<int>(std::ceil(kDoorway_m / plan.resolution_m));
    const cv::Rect around(static_cast<int>(cell.x()) - reach, static_cast<int>(cell.y()) - reach, 2 * reach, 2 * reach);
    isOfRoom(around & cv::Rect({}, isOfRoom.size())).setTo(255);
  }
  mapping::FloorPlan own{cv::Mat(plan.cells.size(), CV_8UC1, cv::Scalar(mapping::FloorPlan::kOccupied)),
                         plan.resolution_m, plan.origin_m};
  plan.cells.copyTo(own.cells, isOfRoom);
  return own;
}

/// Around a corner a way bends in every other cell; as near as a cell (Douglas and Peucker), few of them do.
std::vector<Eigen::Vector2d> withFewBends(const std::vector<Eigen::Vector2d>& way_m, double cell_m) {
  std::vector<cv::Point2f> corners;
  for (const auto& corner_m : way_m) {
    const Eigen::Vector2f from_start = (corner_m - way_m.front()).cast<float>();
    corners.emplace_back(from_start.x(), from_start.y());
  }
  std::vector<cv::Point2f> kept;
  cv::approxPolyDP(corners, kept, cell_m, false);
  std::vector<Eigen::Vector2d> fewer_m;
  for (const auto& corner : kept) fewer_m.emplace_back(way_m.front() + Eigen::Vector2d(corner.x, corner.y));
  return fewer_m;
}

std::optional<std::vector<Eigen::Vector2d>> wayBetween(const FloorWays& ways, double cell_m, const Eigen::Vector2d& a,
                                                       const Eigen::Vector2d& b) {
  const auto from = ways.freeCellNear(a, cell_m);
  const auto to = ways.freeCellNear(b, cell_m);
  const auto way_m = from && to ? ways.wayBetween(*from, *to) : std::nullopt;
  return way_m ? std::optional(withFewBends(*way_m, cell_m)) : std::nullopt;
}

Ways allWays(const std::vector<Terminal>& terminals, const FloorWays& floor, double cell_m) {
  Ways ways;
  for (std::size_t i = 0; i < terminals.size(); ++i) {
    for (std::size_t j = i + 1; j < terminals.size(); ++j) {
      if (auto way = wayBetween(floor, cell_m, terminals[i].p_map_m, terminals[j].p_map_m))
        ways.emplace(std::pair(i, j), std::move(*way));
    }
  }
  return ways;
}

double lengthOf_m(const Ways& ways, std::size_t a, std::size_t b) {
  const auto way = ways.find(std::minmax(a, b));
  return way == ways.end() ? std::numeric_limits<double>::infinity()
                           : query::lengthOf_m(way->second.front(), way->second);
}

/// Whether there is a third that is nearer to both than they are to each other.
bool isBetween(const Ways& ways, std::size_t a, std::size_t b, std::size_t count) {
  const double length_m = lengthOf_m(ways, a, b);
  for (std::size_t third = 0; third < count; ++third) {
    if (third == a || third == b) continue;
    if (std::max(lengthOf_m(ways, a, third), lengthOf_m(ways, third, b)) < length_m) return true;
  }
  return false;
}

/// What the zones along a lane say of going it.
class LaneRules {
 public:
  explicit LaneRules(const std::vector<mapping::Zone>& zones)
      : slow_(mapping::zonesOfType(zones, mapping::ZoneType::Slow)),
        oneWay_(mapping::zonesOfType(zones, mapping::ZoneType::OneWay)) {}

  [[nodiscard]] bool mayGo(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) const {
    return std::none_of(oneWay_.begin(), oneWay_.end(), [&](const mapping::Zone& zone) {
      const Eigen::Vector2d direction(std::cos(zone.direction_rad), std::sin(zone.direction_rad));
      return leadsThrough(zone, from_m, to_m) && (to_m - from_m).dot(direction) < 0.0;
    });
  }

  /// 0 where no zone limits it.
  [[nodiscard]] double maxSpeed_mps(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) const {
    double slowest_mps = 0.0;
    for (const mapping::Zone& zone : slow_) {
      if (!leadsThrough(zone, from_m, to_m)) continue;
      slowest_mps = slowest_mps > 0.0 ? std::min(slowest_mps, zone.maxSpeed_mps) : zone.maxSpeed_mps;
    }
    return slowest_mps;
  }

 private:
  static bool leadsThrough(const mapping::Zone& zone, const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) {
    const int steps = std::max(1, static_cast<int>(std::ceil((to_m - from_m).norm() / kSampling_m)));
    for (int i = 0; i <= steps; ++i) {
      if (mapping::contains(zone, from_m + (to_m - from_m) * i / steps)) return true;
    }
    return false;
  }

  std::vector<mapping::Zone> slow_;
  std::vector<mapping::Zone> oneWay_;
};

void addLanes(RouteNetwork& network, std::size_t a, std::size_t b, const LaneRules& rules) {
  const Eigen::Vector2d& a_m = network.waypoints[a].p_map_m;
  const Eigen::Vector2d& b_m = network.waypoints[b].p_map_m;
  const double maxSpeed_mps = rules.maxSpeed_mps(a_m, b_m);
  if (rules.mayGo(a_m, b_m)) network.lanes.push_back({a, b, maxSpeed_mps});
  if (rules.mayGo(b_m, a_m)) network.lanes.push_back({b, a, maxSpeed_mps});
}

/// By way of its bends, which become waypoints without a name.
void addWay(RouteNetwork& network, const Terminal& from, const Terminal& to, const std::vector<Eigen::Vector2d>& way_m,
            const LaneRules& rules) {
  std::size_t last = from.waypoint;
  for (std::size_t i = 1; i + 1 < way_m.size(); ++i) {
    network.waypoints.push_back({{}, way_m[i]});
    addLanes(network, last, network.waypoints.size() - 1, rules);
    last = network.waypoints.size() - 1;
  }
  addLanes(network, last, to.waypoint, rules);
}

/// Builds the network; remembers where its named waypoints are.
class NetworkBuilder {
 public:
  NetworkBuilder(const Rooms& rooms, const DrivableFloor& floor, const std::vector<mapping::Zone>& zones)
      : rooms_(rooms), floor_(floor), rules_(zones) {}

  RoutesThrough build() {
    for (const Door& door : rooms_.doors)
      atDoor_.push_back(addPlace(nameOf(door, rooms_), door.middle_m(), kDoorReach_m));
    for (const Room& room : rooms_.all) joinWithin(room);
    return std::move(routes_);
  }

 private:
  std::optional<Terminal> addPlace(const std::string& name, const Eigen::Vector2d& p_map_m, double reach_m) {
    const auto place = floor_.nearestFree(p_map_m, reach_m);
    if (!place) {
      routes_.leftOut.push_back(name);
      return std::nullopt;
    }
    routes_.network.waypoints.push_back({unused(name), *place});
    return Terminal{routes_.network.waypoints.size() - 1, *place};
  }

  /// Two doors may join the same rooms.
  std::string unused(const std::string& name) {
    const int count = ++timesUsed_[name];
    return count == 1 ? name : name + " (" + std::to_string(count) + ")";
  }

  void joinWithin(const Room& room) {
    std::vector<const Door*> doors;
    std::vector<Terminal> terminals;
    if (const auto middle = addPlace(room.name, room.middle_m, kMiddleReach_m)) terminals.push_back(*middle);
    for (std::size_t i = 0; i < rooms_.doors.size(); ++i) {
      const Door& door = rooms_.doors[i];
      if (!atDoor_[i] || (door.room != room.id && door.other != room.id)) continue;
      doors.push_back(&door);
      terminals.push_back(*atDoor_[i]);
    }
    const double cell_m = floor_.plan().resolution_m;
    const FloorWays own(floorOf(room, doors, rooms_, floor_.plan()), cell_m);
    const Ways ways = allWays(terminals, own, cell_m);
    for (const auto& [ends, way_m] : ways) {
      if (!isBetween(ways, ends.first, ends.second, terminals.size()))
        addWay(routes_.network, terminals[ends.first], terminals[ends.second], way_m, rules_);
    }
  }

  const Rooms& rooms_;
  const DrivableFloor& floor_;
  LaneRules rules_;
  RoutesThrough routes_;
  std::vector<std::optional<Terminal>> atDoor_;
  std::map<std::string, int> timesUsed_;
};

}  // namespace

RoutesThrough routesThrough(const Rooms& rooms, const DrivableFloor& floor, const std::vector<mapping::Zone>& zones) {
  if (rooms.ids.size() != floor.plan().cells.size()) return {};  // of no plan, or of another one
  return NetworkBuilder(rooms, floor, zones).build();
}

}  // namespace wardslam::query
