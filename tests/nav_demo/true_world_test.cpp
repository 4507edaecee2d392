#include "true_world.h"

#include <gtest/gtest.h>

#include <cmath>

#include "range_scanner.h"

namespace wardslam::nav_demo {
namespace {

constexpr double kCell_m = 0.02;

/// 4 m by 4 m from (-2, -2), with walls of one cell around and a pillar from 1.0 to 1.2 m along both axes.
TrueWorld makeRoom() {
  mapping::FloorPlan floor;
  floor.resolution_m = kCell_m;
  floor.origin_m = {-2.0, -2.0};
  floor.cells = cv::Mat(200, 200, CV_8UC1, cv::Scalar(mapping::FloorPlan::kOccupied));
  floor.cells(cv::Rect(1, 1, 198, 198)).setTo(mapping::FloorPlan::kFree);
  floor.cells(cv::Rect(150, 150, 10, 10)).setTo(mapping::FloorPlan::kOccupied);
  return TrueWorld(floor);
}

TEST(TrueWorld, KnowsTheRoomAroundAPlace) {
  const TrueWorld room = makeRoom();
  EXPECT_NEAR(room.roomAt_m({1.1, 0.5}), 0.5, kCell_m);
  EXPECT_NEAR(room.roomAt_m({-1.5, 0.0}), 0.48, kCell_m);
  EXPECT_NEAR(room.roomAt_m({0.7, 0.6}), std::hypot(0.3, 0.4), kCell_m);  // to the pillar's corner
  EXPECT_EQ(room.roomAt_m({1.1, 1.1}), 0.0);
  EXPECT_EQ(room.roomAt_m({5.0, 0.0}), 0.0);
}

TEST(TrueWorld, SeesThingsAndPeopleUpToTheRange) {
  const TrueWorld room = makeRoom();
  const Eigen::Vector2d along(1.0, 0.0);
  EXPECT_NEAR(room.sightFrom_m({0.0, 1.1}, along, 5.0, {}), 1.0, kCell_m);
  EXPECT_NEAR(room.sightFrom_m({0.0, 0.5}, along, 5.0, {}), 1.98, kCell_m);  // past the pillar, to the wall
  EXPECT_EQ(room.sightFrom_m({0.0, 0.5}, along, 1.5, {}), 1.5);
  EXPECT_NEAR(room.sightFrom_m({0.0, 0.5}, along, 5.0, {{{1.0, 0.5}, 0.25}}), 0.75, 1e-9);
  EXPECT_NEAR(room.sightFrom_m({0.0, 0.5}, along, 5.0, {{{-1.0, 0.5}, 0.25}}), 1.98, kCell_m);  // behind
  EXPECT_NEAR(room.sightFrom_m({0.0, 0.5}, along, 5.0, {{{1.0, 0.8}, 0.25}}), 1.98, kCell_m);   // beside
}

TEST(RangeScanner, LooksAheadFromSideToSide) {
  ScannerOptions options;
  options.fieldOfView_rad = M_PI;
  options.rays = 3;
  options.range_m = 1.9;
  // Looks along y from (1.1, 0): the right is the wall 0.88 m off, ahead the pillar 1 m off, the left too far.
  const Eigen::Isometry2d pose = Eigen::Translation2d(1.1, 0.0) * Eigen::Rotation2Dd(M_PI / 2);
  const auto points = scan(makeRoom(), {}, pose, options);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_LT((points[0] - Eigen::Vector2d(0.0, -0.88)).norm(), kCell_m);
  EXPECT_LT((points[1] - Eigen::Vector2d(1.0, 0.0)).norm(), kCell_m);
}

}  // namespace
}  // namespace wardslam::nav_demo
