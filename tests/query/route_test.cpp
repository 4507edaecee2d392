#include "wardslam/query/route.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wardslam::query {
namespace {

constexpr double kRadius_m = 0.25;

/// 4 m by 3 m in cells of 0.05 m, its corner at (-1, -1), cut in two by a wall along x = 1 with a door of `door_m`
/// whose middle is at y = 1.
mapping::FloorPlan makeRooms(double door_m) {
  mapping::FloorPlan plan;
  plan.origin_m = {-1.0, -1.0};
  plan.cells = cv::Mat(60, 80, CV_8UC1, cv::Scalar(mapping::FloorPlan::kFree));
  plan.cells.col(40).setTo(mapping::FloorPlan::kOccupied);
  const int half = static_cast<int>(std::lround(door_m / 2 / plan.resolution_m));
  if (half > 0) plan.cells.col(40).rowRange(40 - half, 40 + half).setTo(mapping::FloorPlan::kFree);
  return plan;
}

DrivableFloor drivable(const mapping::FloorPlan& plan, const std::vector<mapping::Zone>& forbidden = {}) {
  return {plan, {kRadius_m, forbidden, false}};
}

TEST(Route, GoesThroughTheDoorAndKeepsTheRadius) {
  const auto plan = makeRooms(0.8);
  const Eigen::Vector2d from(0.0, 0.0);
  const auto route = planRoute(drivable(plan), from, {2.0, 0.0});
  ASSERT_TRUE(route);
  EXPECT_LT((route->back() - Eigen::Vector2d(2.0, 0.0)).norm(), 1e-6);
  // The robot's middle passes the door between y = 0.85 and 1.15: at least twice the way from (0, 0) to (1, 0.85).
  EXPECT_GT(lengthOf_m(from, *route), 2 * std::hypot(1.0, 0.85));
  EXPECT_LT(lengthOf_m(from, *route), 1.15 * 2 * std::hypot(1.0, 0.85));
  for (const auto& p : *route) {
    if (std::abs(p.x() - 1.0) > kRadius_m) continue;
    EXPECT_GT(p.y(), 0.6 + kRadius_m - 0.05);
    EXPECT_LT(p.y(), 1.4 - kRadius_m + 0.05);
  }
}

TEST(Route, NeedsADoorWideEnough) {
  EXPECT_FALSE(planRoute(drivable(makeRooms(0.4)), {0.0, 0.0}, {2.0, 0.0}));
  EXPECT_FALSE(planRoute(drivable(makeRooms(0.0)), {0.0, 0.0}, {2.0, 0.0}));
}

TEST(Route, GoesAroundForbiddenZones) {
  const mapping::Zone zone = {"round", {{-0.2, -0.5}, {0.2, -0.5}, {0.2, 0.8}, {-0.2, 0.8}}};
  const auto plan = makeRooms(0.8);
  const auto straight = planRoute(drivable(plan), {-0.7, 0.0}, {0.7, 0.0});
  const auto around = planRoute(drivable(plan, {zone}), {-0.7, 0.0}, {0.7, 0.0});
  ASSERT_TRUE(straight && around);
  EXPECT_LT(lengthOf_m({-0.7, 0.0}, *straight), 1.45);
  for (const auto& p : *around) EXPECT_GE(mapping::distance_m(zone, p), kRadius_m);
  EXPECT_GT(lengthOf_m({-0.7, 0.0}, *around), 2.0);
}

TEST(Route, StartsBesideAnObstacleByMovingAway) {
  const auto route = planRoute(drivable(makeRooms(0.8)), {0.9, -0.5}, {-0.5, -0.5});
  ASSERT_TRUE(route);
  EXPECT_LT(route->front().x(), 0.9 - 0.05);
  EXPECT_FALSE(planRoute(drivable(makeRooms(0.8)), {0.9, -0.5}, {-0.5, -0.5}, 0.4, 0.05));
}

TEST(Route, ToWhereOneIsHasOnePoint) {
  const auto route = planRoute(drivable(makeRooms(0.8)), {0.0, 0.0}, {0.01, 0.01});
  ASSERT_TRUE(route);
  EXPECT_EQ(route->size(), 1U);
}

TEST(Route, OutsideOfThePlanThereIsNone) {
  EXPECT_FALSE(planRoute(drivable(makeRooms(0.8)), {0.0, 0.0}, {20.0, 0.0}));
  EXPECT_FALSE(planRoute(drivable(makeRooms(0.8)), {20.0, 0.0}, {0.0, 0.0}));
}

}  // namespace
}  // namespace wardslam::query
