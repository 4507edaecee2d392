#include "judge.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wardslam::nav_demo {
namespace {

constexpr double kRadius_m = 0.25;

/// 4 m by 4 m of free floor around the origin, walls at its edges.
TrueWorld makeHall() {
  mapping::FloorPlan floor;
  floor.resolution_m = 0.02;
  floor.origin_m = {-2.0, -2.0};
  floor.cells = cv::Mat(200, 200, CV_8UC1, cv::Scalar(mapping::FloorPlan::kOccupied));
  floor.cells(cv::Rect(1, 1, 198, 198)).setTo(mapping::FloorPlan::kFree);
  return TrueWorld(floor);
}

class JudgeTest : public testing::Test {
 protected:
  TrueWorld hall_ = makeHall();
};

TEST_F(JudgeTest, MeasuresFromHullToHull) {
  Judge judge(hall_, {}, Eigen::Isometry2d::Identity(), kRadius_m);
  judge.look({0.0, 0.0}, {{{1.0, 0.0}, 0.25}});
  judge.look({0.0, 1.0}, {{{1.0, 1.0}, 0.25}});
  EXPECT_NEAR(judge.verdict().nearestPerson_m, 0.5, 1e-9);
  EXPECT_NEAR(judge.verdict().nearestThing_m, 0.73, 0.02);
  EXPECT_NEAR(judge.verdict().way_m, 1.0, 1e-9);
  EXPECT_EQ(judge.verdict().encounters, 1);
  EXPECT_TRUE(judge.verdict().isClean());
}

TEST_F(JudgeTest, CountsEveryContactOnce) {
  Judge judge(hall_, {}, Eigen::Isometry2d::Identity(), kRadius_m);
  const std::vector<Disc> somebody = {{{0.0, 0.0}, 0.25}};
  for (const double x_m : {-1.0, -0.49, -0.48, -1.0, -0.3}) judge.look({x_m, 0.0}, somebody);
  EXPECT_EQ(judge.verdict().contactsWithPeople, 2);
  EXPECT_EQ(judge.verdict().contactsWithThings, 0);
  judge.look({1.74, 0.0}, somebody);
  EXPECT_EQ(judge.verdict().contactsWithThings, 1);
  EXPECT_FALSE(judge.verdict().isClean());
}

TEST_F(JudgeTest, ZonesAreThoseOfTheMap) {
  // The map is turned a quarter against the world: (1, 0) of the map is (0, 1) of the world.
  const Eigen::Isometry2d T_world_map(Eigen::Rotation2Dd(M_PI / 2));
  const mapping::Zone zone = {"store", {{1.0, -1.0}, {2.0, -1.0}, {2.0, 1.0}, {1.0, 1.0}}};
  Judge judge(hall_, {zone}, T_world_map, kRadius_m);
  judge.look({1.5, 0.0}, {});  // (0, -1.5) of the map
  judge.look({0.0, 0.74}, {});
  EXPECT_EQ(judge.verdict().zonesEntered, 0);
  judge.look({0.0, 0.76}, {});  // its rim is in
  EXPECT_EQ(judge.verdict().zonesEntered, 1);
}

}  // namespace
}  // namespace wardslam::nav_demo
