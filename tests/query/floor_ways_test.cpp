#include "floor_ways.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/hand_made_map.h"

namespace wardslam::query {
namespace {

/// 2 m by 1 m of free floor in cells of 0.1 m, its corner at (10, 20).
mapping::FloorPlan makeRoom() {
  mapping::FloorPlan plan;
  plan.resolution_m = 0.1;
  plan.origin_m = {10, 20};
  plan.cells = cv::Mat(10, 20, CV_8UC1, cv::Scalar(mapping::FloorPlan::kFree));
  return plan;
}

std::optional<double> distance_m(const FloorWays& ways, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const auto goal = ways.freeCellNear(to, 0.1);
  return ways.walk(ways.freeCellNear(from, 0.1).value(), [&](auto cell) { return cell == goal; });
}

TEST(FloorWays, StraightWaysHaveTheirLength) {
  const FloorWays ways(makeRoom());
  EXPECT_NEAR(distance_m(ways, {10.05, 20.05}, {11.95, 20.05}).value(), 1.9, 1e-9);
  EXPECT_NEAR(distance_m(ways, {10.05, 20.05}, {10.05, 20.05}).value(), 0.0, 1e-9);
}

TEST(FloorWays, DiagonalStepsAreLonger) {
  const FloorWays ways(makeRoom());
  EXPECT_NEAR(distance_m(ways, {10.05, 20.05}, {10.95, 20.95}).value(), 9 * 0.14, 1e-9);
}

TEST(FloorWays, WaysStayOnThePlan) {
  mapping::FloorPlan plan = makeRoom();
  plan.cells.col(10).setTo(
      mapping::FloorPlan::kOccupied);  // from wall to wall: along the border, too, nothing leads past
  EXPECT_FALSE(distance_m(FloorWays(plan), {10.05, 20.05}, {11.95, 20.05}));
}

TEST(FloorWays, AWayRoundACornerHasThatCorner) {
  mapping::FloorPlan plan = makeRoom();
  plan.cells(cv::Rect(10, 0, 1, 9)).setTo(mapping::FloorPlan::kOccupied);  // open in the topmost row, y = 20.95
  const FloorWays ways(plan);
  const auto way =
      ways.wayBetween(ways.freeCellNear({10.05, 20.05}, 0.1).value(), ways.freeCellNear({11.95, 20.05}, 0.1).value());
  ASSERT_TRUE(way);
  EXPECT_NEAR((way->front() - Eigen::Vector2d(10.05, 20.05)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((way->back() - Eigen::Vector2d(11.95, 20.05)).norm(), 0.0, 1e-9);
  double length_m = 0.0;
  for (std::size_t i = 1; i < way->size(); ++i) length_m += ((*way)[i] - (*way)[i - 1]).norm();
  const double shortest_m = 2 * std::hypot(0.95, 0.9);  // to the middle of the opening and back
  EXPECT_GT(length_m, shortest_m - 1e-9);
  EXPECT_LT(length_m, 1.05 * shortest_m);
  EXPECT_TRUE(std::all_of(way->begin(), way->end(),
                          [](const auto& p) { return p.x() < 11.0 || p.x() > 11.1 || p.y() > 20.9; }));
}

TEST(FloorWays, AWayInSightIsOneLine) {
  const FloorWays ways(makeRoom());
  const auto way =
      ways.wayBetween(ways.freeCellNear({10.05, 20.05}, 0.1).value(), ways.freeCellNear({11.75, 20.65}, 0.1).value());
  ASSERT_TRUE(way);
  EXPECT_EQ(way->size(), 2U);
  const auto here = ways.freeCellNear({10.05, 20.05}, 0.1).value();
  EXPECT_EQ(ways.wayBetween(here, here).value().size(), 1U);
}

TEST(FloorWays, SmallCellsArePooledAndFreeOnlyWhenAllAre) {
  mapping::FloorPlan plan;
  plan.cells =
      cv::Mat(21, 40, CV_8UC1, cv::Scalar(mapping::FloorPlan::kFree));  // 0.05 m; the 21st row fills no cell of 0.1 m
  plan.cells.at<unsigned char>(5, 11) = mapping::FloorPlan::kUnknown;
  const FloorWays ways(plan);
  int free = 0;
  ways.forEachFreeCellNear({Eigen::Vector2d(-5, -5), Eigen::Vector2d(5, 5)}, 0.0, [&](auto) { ++free; });
  EXPECT_EQ(free, 10 * 20 - 1);
  EXPECT_FALSE(ways.freeCellNear({0.55, 0.25}, 0.04)) << "one quarter of this cell is unknown";
  EXPECT_TRUE(ways.freeCellNear({0.55, 0.25}, 0.11));
}

TEST(FloorWays, CellsNearABoxLieWithinReachOfItsEdge) {
  const FloorWays ways(makeRoom());
  int near = 0;  // centres 10.05, 10.15, …; box ends at x = 10.5, reach 0.2 leaves 10.55 and 10.65 beyond it
  ways.forEachFreeCellNear({Eigen::Vector2d(9, 19), Eigen::Vector2d(10.5, 22)}, 0.2, [&](auto) { ++near; });
  EXPECT_EQ(near, 7 * 10);
}

TEST(FloorWays, APlanWithoutCellsHasNoWays) { EXPECT_FALSE(FloorWays({}).freeCellNear({0, 0}, 100.0)); }

}  // namespace
}  // namespace wardslam::query
