#include "wardslam/query/routes_through.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <optional>
#include <set>

#include "wardslam/building/room_finder.h"

namespace wardslam::query {
namespace {

using mapping::FloorPlan;
using mapping::Zone;
using mapping::ZoneType;

/// A corridor 10 m x 2 m along y = 1; north of it two rooms 4.8 m x 4 m, doors of 1 m at x = 2.5 and x = 7.5.
class RoutesThroughTest : public testing::Test {
 protected:
  RoutesThroughTest() {
    plan_.cells = cv::Mat(140, 208, CV_8UC1, cv::Scalar(FloorPlan::kOccupied));
    plan_.origin_m = {-0.2, -0.2};
    open(0, 0, 10, 2);
    open(0, 2.2, 4.8, 6.2);
    open(5.0, 2.2, 10, 6.2);
    open(2, 2, 3, 2.2);
    open(7, 2, 8, 2.2);
  }

  void open(double x0_m, double y0_m, double x1_m, double y1_m, unsigned char what = FloorPlan::kFree) {
    const auto cell = [](double at_m) { return static_cast<int>(std::lround((at_m + 0.2) / 0.05)); };
    plan_.cells(cv::Range(cell(y0_m), cell(y1_m)), cv::Range(cell(x0_m), cell(x1_m))).setTo(what);
  }

  RoutesThrough routes(double radius_m = 0.25) const {
    const DrivableFloor floor(plan_, {radius_m, mapping::zonesOfType(zones_, ZoneType::Forbidden), false});
    return routesThrough(building::findRooms(plan_, {}, {}), floor, zones_);
  }

  static std::optional<std::size_t> named(const building::RouteNetwork& network, const std::string& name) {
    for (std::size_t i = 0; i < network.waypoints.size(); ++i) {
      if (network.waypoints[i].name == name) return i;
    }
    return std::nullopt;
  }

  /// All that lanes lead to from there, not by way of one.
  static std::set<std::size_t> reachable(const building::RouteNetwork& network, std::size_t from,
                                         std::optional<std::size_t> closed = std::nullopt) {
    std::set<std::size_t> reached{from};
    for (std::size_t before = 0; before != reached.size();) {
      before = reached.size();
      for (const auto& lane : network.lanes) {
        if (reached.count(lane.from) != 0 && lane.to != closed) reached.insert(lane.to);
      }
    }
    return reached;
  }

  FloorPlan plan_;
  std::vector<Zone> zones_;
};

TEST_F(RoutesThroughTest, LeadFromEveryRoomToEveryOther) {
  const auto found = routes();
  EXPECT_THAT(found.leftOut, testing::IsEmpty());
  std::set<std::string> names;
  for (const auto& waypoint : found.network.waypoints) {
    if (waypoint.name.empty()) continue;
    EXPECT_TRUE(names.insert(waypoint.name).second) << waypoint.name;
  }
  EXPECT_EQ(names.size(), 5U) << "three rooms and two doors";
  for (std::size_t i = 0; i < found.network.waypoints.size(); ++i)
    EXPECT_EQ(reachable(found.network, i).size(), found.network.waypoints.size());
}

TEST_F(RoutesThroughTest, KeepAwayFromWalls) {
  const DrivableFloor floor(plan_, {0.25, {}, false});
  const auto found = routes();
  for (const auto& lane : found.network.lanes) {
    const auto& a_m = found.network.waypoints[lane.from].p_map_m;
    const auto& b_m = found.network.waypoints[lane.to].p_map_m;
    for (int i = 0; i <= 20; ++i)
      EXPECT_TRUE(floor.nearestFree(a_m + (b_m - a_m) * i / 20.0, 0.08)) << a_m.transpose() << " " << b_m.transpose();
  }
}

/// Half a metre of something beside the western door, whose corners are rounded by circles of 0.45 m.
TEST_F(RoutesThroughTest, BendSeldom) {
  open(3.1, 1.55, 3.6, 2.0, FloorPlan::kOccupied);
  const auto network = routes(0.45).network;
  const auto bends = std::count_if(network.waypoints.begin(), network.waypoints.end(),
                                   [](const auto& waypoint) { return waypoint.name.empty(); });
  EXPECT_EQ(bends, 2) << "of three from cell to cell";
}

/// Between the doors lies the corridor's middle: no lane leads past it.
TEST_F(RoutesThroughTest, LeadByWhatLiesBetween) {
  const auto network = routes().network;
  const auto rooms = building::findRooms(plan_, {}, {});
  const auto west = named(network, rooms.at({2.5, 4.0})->name);
  const auto east = named(network, rooms.at({7.5, 4.0})->name);
  const auto corridor = named(network, rooms.at({5.0, 1.0})->name);
  ASSERT_TRUE(west && east && corridor);
  EXPECT_EQ(reachable(network, *west, *corridor).count(*east), 0U);
}

TEST_F(RoutesThroughTest, NoTwoPlacesAreCalledTheSame) {
  open(2, 2, 3, 2.2, FloorPlan::kOccupied);  // two other doors, with more than an island of wall between
  open(0.1, 2, 1.0, 2.2);
  open(3.8, 2, 4.7, 2.2);
  std::set<std::string> names;
  std::size_t places = 0;
  for (const auto& waypoint : routes().network.waypoints) {
    if (waypoint.name.empty()) continue;
    names.insert(waypoint.name);
    ++places;
  }
  EXPECT_EQ(places, 6U);
  EXPECT_EQ(names.size(), places);
}

TEST_F(RoutesThroughTest, NoLaneGoesAgainstAOneWayZone) {
  zones_ = {{"east only", {{4, 0}, {6, 0}, {6, 2}, {4, 2}}, ZoneType::OneWay, 0.0, 0.0}};
  const auto network = routes().network;
  const auto rooms = building::findRooms(plan_, {}, {});
  const auto west = named(network, rooms.at({2.5, 4.0})->name);
  const auto east = named(network, rooms.at({7.5, 4.0})->name);
  ASSERT_TRUE(west && east);
  EXPECT_EQ(reachable(network, *west).count(*east), 1U);
  EXPECT_EQ(reachable(network, *east).count(*west), 0U);
}

TEST_F(RoutesThroughTest, SlowZonesLimitTheLanesThroughThem) {
  zones_ = {{"slow", {{0, 2.2}, {4.8, 2.2}, {4.8, 6.2}, {0, 6.2}}, ZoneType::Slow, 0.5},
            {"slower", {{0, 3}, {4.8, 3}, {4.8, 6.2}, {0, 6.2}}, ZoneType::Slow, 0.2}};
  const auto network = routes().network;
  int limited = 0;
  for (const auto& lane : network.lanes) {
    const auto& a_m = network.waypoints[lane.from].p_map_m;
    const auto& b_m = network.waypoints[lane.to].p_map_m;
    const bool isInside = std::max(a_m.y(), b_m.y()) > 3.1 && std::max(a_m.x(), b_m.x()) < 4.8;
    EXPECT_EQ(lane.maxSpeed_mps, isInside ? 0.2 : 0.0) << a_m.transpose() << " to " << b_m.transpose();
    limited += isInside ? 1 : 0;
  }
  EXPECT_GE(limited, 2);
}

TEST_F(RoutesThroughTest, AForbiddenZoneClosesTheWay) {
  zones_ = {{"closed", {{4.5, -0.2}, {5.5, -0.2}, {5.5, 2}, {4.5, 2}}, ZoneType::Forbidden}};
  const auto network = routes().network;
  const auto rooms = building::findRooms(plan_, {}, {});
  const auto west = named(network, rooms.at({2.5, 4.0})->name);
  const auto east = named(network, rooms.at({7.5, 4.0})->name);
  ASSERT_TRUE(west && east);
  EXPECT_EQ(reachable(network, *west).count(*east), 0U);
}

TEST_F(RoutesThroughTest, DoorsTooNarrowForTheRobotAreTold) {
  open(7, 2, 7.3, 2.2, FloorPlan::kOccupied);  // 0.7 m are left
  const auto found = routes(0.45);
  ASSERT_EQ(found.leftOut.size(), 1U);
  EXPECT_THAT(found.leftOut.front(), testing::HasSubstr(" to "));
}

TEST_F(RoutesThroughTest, WithoutRoomsThereAreNone) {
  plan_.cells.setTo(FloorPlan::kOccupied);
  EXPECT_TRUE(routes().network.lanes.empty());
  plan_.cells = cv::Mat();
  EXPECT_TRUE(routes().network.waypoints.empty());
}

}  // namespace
}  // namespace wardslam::query
