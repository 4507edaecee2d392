#include "wardslam/query/drivable_floor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/hand_made_map.h"

namespace wardslam::query {
namespace {

constexpr double kReach_m = 0.5;

/// 2 m by 1 m in cells of 0.1 m, its corner at (1, 2), all free.
mapping::FloorPlan makeRoom() {
  mapping::FloorPlan plan;
  plan.resolution_m = 0.1;
  plan.origin_m = {1.0, 2.0};
  plan.cells = cv::Mat(10, 20, CV_8UC1, cv::Scalar(mapping::FloorPlan::kFree));
  return plan;
}

DrivingRules radius(double radius_m) {
  DrivingRules rules;
  rules.radius_m = radius_m;
  return rules;
}

int freeCells(const DrivableFloor& floor) { return cv::countNonZero(floor.plan().cells == mapping::FloorPlan::kFree); }

TEST(DrivableFloor, TheMiddleKeepsTheRadiusFromWhatIsNotFree) {
  const DrivableFloor floor(makeRoom(), radius(0.25));
  // Middles of cells 0, 1, … are 0.05, 0.15, 0.25, … m from the edge: two rows and columns are lost on each side.
  EXPECT_EQ(freeCells(floor), (10 - 4) * (20 - 4));
}

TEST(DrivableFloor, UnknownFloorIsNotFreeUnlessToldSo) {
  mapping::FloorPlan plan = makeRoom();
  plan.cells.colRange(10, 20).setTo(mapping::FloorPlan::kUnknown);
  EXPECT_EQ(freeCells(DrivableFloor(plan, radius(0.05))), 10 * 10);
  DrivingRules bold = radius(0.05);
  bold.unknownIsFree = true;
  EXPECT_EQ(freeCells(DrivableFloor(plan, bold)), 10 * 20);
}

TEST(DrivableFloor, NoPartOfTheRobotEntersAForbiddenZone) {
  DrivingRules rules = radius(0.15);
  rules.forbidden = {{"store", {{2.03, 1}, {4, 1}, {4, 4}, {2.03, 4}}}};
  const DrivableFloor floor(makeRoom(), rules);
  for (int row = 0; row < 10; ++row) {
    for (int column = 0; column < 20; ++column) {
      if (floor.plan().cells.at<unsigned char>(row, column) != mapping::FloorPlan::kFree) continue;
      EXPECT_LE(1.0 + 0.1 * (column + 0.5) + 0.15, 2.03);
    }
  }
  EXPECT_TRUE(floor.nearestFree({1.5, 2.5}, 0.0));
}

TEST(DrivableFloor, FindsTheNearestFreePlaceWithinReach) {
  const DrivableFloor floor(makeRoom(), radius(0.25));
  const Eigen::Vector2d inside(1.62, 2.53);
  EXPECT_EQ(*floor.nearestFree(inside, 0.0), inside);
  const auto moved = floor.nearestFree({1.05, 2.55}, 0.3);
  ASSERT_TRUE(moved);
  EXPECT_NEAR((*moved - Eigen::Vector2d(1.25, 2.55)).norm(), 0.0, 1e-9);
  EXPECT_FALSE(floor.nearestFree({1.05, 2.55}, 0.15));
  EXPECT_FALSE(floor.nearestFree({9.0, 9.0}, 0.15));
}

TEST(DrivableFloor, StopsBesideAnObjectAndFacesIt) {
  mapping::FloorPlan plan = makeRoom();
  plan.cells(cv::Rect(14, 0, 6, 10)).setTo(mapping::FloorPlan::kOccupied);  // x from 2.4 to 3.0
  const auto bed = test::makeObject(1, test::kBed, {2.7, 2.5, 0.4}, {0.6, 1.0, 0.8});
  const auto spot = DrivableFloor(plan, radius(0.2)).spotBeside(bed, kReach_m);
  ASSERT_TRUE(spot);
  // Middles at x = 2.15 keep 0.25 m from the bed's edge, those at 2.05 0.35 m (no longer "about as near"); of the
  // former those have most room that are 0.25 m or more from the walls.
  EXPECT_NEAR(spot->p_map_m.x(), 2.15, 1e-9);
  EXPECT_GE(spot->p_map_m.y(), 2.25 - 1e-9);
  EXPECT_LE(spot->p_map_m.y(), 2.75 + 1e-9);
  EXPECT_NEAR(spot->yaw_rad, 0.0, 1e-9);
}

TEST(DrivableFloor, KnowsTheFootprintOfATurnedBox) {
  auto bed = test::makeObject(1, test::kBed, {1.9, 2.5, 0.4}, {0.4, 0.2, 0.8});
  bed.orientedBox.T_map_box.rotate(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()));  // now 0.2 by 0.4
  const auto spot = DrivableFloor(makeRoom(), radius(0.2)).spotBeside(bed, kReach_m);
  ASSERT_TRUE(spot);
  const Eigen::Array2d off = (spot->p_map_m - Eigen::Vector2d(1.9, 2.5)).array().abs();
  EXPECT_GE((off - Eigen::Array2d(0.1, 0.2)).max(0.0).matrix().norm(), 0.2 - 1e-9);
}

TEST(DrivableFloor, OnlyOffersWhatAWayLeadsTo) {
  mapping::FloorPlan plan = makeRoom();
  plan.cells.col(10).setTo(mapping::FloorPlan::kOccupied);  // a wall from x = 2.0 to 2.1 with the chair on it
  const auto chair = test::makeObject(1, test::kChair, {2.05, 2.5, 0.4}, {0.1, 0.1, 0.8});
  const DrivableFloor floor(plan, radius(0.15));
  EXPECT_LT(floor.spotBeside(chair, kReach_m, Eigen::Vector2d(1.5, 2.5))->p_map_m.x(), 2.0);
  EXPECT_GT(floor.spotBeside(chair, kReach_m, Eigen::Vector2d(2.5, 2.5))->p_map_m.x(), 2.1);
  EXPECT_FALSE(floor.spotBeside(chair, kReach_m, Eigen::Vector2d(5.0, 5.0)));
}

TEST(DrivableFloor, OffersNothingWhereNothingIsFree) {
  const auto chair = test::makeChair(1, 2.0, 2.5);
  EXPECT_FALSE(DrivableFloor(makeRoom(), radius(0.6)).spotBeside(chair, kReach_m));
  EXPECT_FALSE(DrivableFloor({}, radius(0.1)).spotBeside(chair, kReach_m));
  EXPECT_FALSE(DrivableFloor(makeRoom(), radius(0.2)).spotBeside(test::makeChair(1, 9.0, 9.0), kReach_m));
}

}  // namespace
}  // namespace wardslam::query
