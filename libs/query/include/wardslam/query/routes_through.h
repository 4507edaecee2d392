#pragma once

#include <string>
#include <vector>

#include "wardslam/building/rooms.h"
#include "wardslam/building/route_network.h"
#include "wardslam/mapping/zone.h"
#include "wardslam/query/drivable_floor.h"

namespace wardslam::query {

/// Ways through rooms, and what they do not lead to.
struct RoutesThrough {
  building::RouteNetwork network;
  std::vector<std::string> leftOut;  ///< Rooms and doors in which a robot has no place, by name.
};

/// Within each room its middle and its doors are joined where no third of them lies between (relative neighbourhood
/// graph, Toussaint 1980, by the length of ways), along ways of the robot's middle, to within a cell, straight between
/// bends. Lanes go in both directions, but for one-way zones: there none goes against the zone's direction; slow zones
/// limit theirs.
[[nodiscard]] RoutesThrough routesThrough(const building::Rooms& rooms, const DrivableFloor& floor,
                                          const std::vector<mapping::Zone>& zones);

}  // namespace wardslam::query
