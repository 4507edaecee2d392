#include "wardslam/navigation/obstacles.h"

#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>

#include <cmath>

#include "wardslam/core/mrpt_compat.h"

namespace wardslam::navigation {
namespace {

/// 4 m by 4 m, cells of 0.1 m, its corner at the origin; occupied: a block of 3 by 3 cells around (2.05, 1.05).
mapping::FloorPlan makePlan() {
  mapping::FloorPlan plan;
  plan.resolution_m = 0.1;
  plan.cells = cv::Mat(40, 40, CV_8UC1, cv::Scalar(mapping::FloorPlan::kFree));
  plan.cells(cv::Rect(19, 9, 3, 3)).setTo(mapping::FloorPlan::kOccupied);
  return plan;
}

mapping::FloorPlan emptyPlan() {
  mapping::FloorPlan plan = makePlan();
  plan.cells.setTo(mapping::FloorPlan::kFree);
  return plan;
}

/// On the floor at (x, y), looking along `yaw_rad`.
Eigen::Isometry3d robotAt(double x_m, double y_m, double yaw_rad) {
  return Eigen::Translation3d(x_m, y_m, 0.0) * Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());
}

bool holds(const SensedObstacles& sensed, const Eigen::Vector3f& p_base_m) {
  for (const auto& p : sensed.p_base_m) {
    if ((p - p_base_m).norm() < 1e-4F) return true;
  }
  return false;
}

TEST(Obstacles, OfTheMapAreItsOutlinesSeenFromTheRobot) {
  const Obstacles obstacles(makePlan());
  const auto sensed = obstacles.sense(robotAt(2.05, 0.05, M_PI / 2));  // looks along y, towards the block
  EXPECT_EQ(sensed.p_base_m.size(), 8U);                               // the middle one is inside
  EXPECT_TRUE(holds(sensed, {0.9F, 0.0F, 0.5F}));                      // its near side, straight ahead
  EXPECT_TRUE(holds(sensed, {0.9F, 0.1F, 0.5F}));                      // x = 1.95 lies to the left
  EXPECT_FALSE(holds(sensed, {1.0F, 0.0F, 0.5F}));
  EXPECT_EQ(sensed.stamp_s, 0.0);
}

TEST(Obstacles, OfTheMapEndAtTheRadius) {
  ObstacleOptions options;
  options.radius_m = 0.95;
  EXPECT_EQ(Obstacles(makePlan(), options).sense(robotAt(2.05, 0.05, 0.0)).p_base_m.size(), 3U);
  EXPECT_TRUE(Obstacles({}, options).sense(robotAt(0, 0, 0)).p_base_m.empty());
}

TEST(Obstacles, WhatWasSeenLastStaysWhereItIsWhenTheRobotMoves) {
  Obstacles obstacles(emptyPlan());
  obstacles.see({{9.0F, 9.0F, 1.0F}}, 10.0);
  obstacles.see({{3.0F, 2.0F, 1.0F}}, 11.0);
  const auto sensed = obstacles.sense(robotAt(3.0, 0.0, M_PI / 2));
  ASSERT_EQ(sensed.p_base_m.size(), 1U);
  EXPECT_TRUE(holds(sensed, {2.0F, 0.0F, 1.0F}));
  EXPECT_EQ(sensed.stamp_s, 11.0);
}

/// A camera 1 m above the floor that looks along x; one image of 3 by 3 pixels with this depth.
class ObstaclesOfAFrame : public testing::Test {
 protected:
  ObstaclesOfAFrame() {
    options_.pixel_step = 1;
    frame_.stamp_s = 5.0;
    frame_.camera.width_px = frame_.camera.height_px = 3;
    frame_.camera.fx_px = frame_.camera.fy_px = 2.0;
    frame_.camera.cx_px = frame_.camera.cy_px = 1.0;
    frame_.depth_m = cv::Mat(3, 3, CV_32FC1, cv::Scalar(2.0));
    odometry_.state = odometry::State::Ok;
    odometry_.T_map_cam = Eigen::Translation3d(0.0, 0.0, 1.0) * core::T_sensor_cam();
  }

  SensedObstacles sense() {
    Obstacles obstacles(emptyPlan(), options_);
    obstacles.onFrame(frame_, odometry_);
    return obstacles.sense(Eigen::Isometry3d::Identity());
  }

  ObstacleOptions options_;
  core::Frame frame_;
  odometry::OdometryResult odometry_;
};

TEST_F(ObstaclesOfAFrame, LieBetweenTheHeights) {
  // Rows look 45 degrees up, level, down: 2 m ahead they are 2 m, 1 m and 0 m high.
  const auto sensed = sense();
  EXPECT_EQ(sensed.p_base_m.size(), 3U);
  EXPECT_TRUE(holds(sensed, {2.0F, 1.0F, 1.0F}));  // left column
  EXPECT_TRUE(holds(sensed, {2.0F, 0.0F, 1.0F}));
  EXPECT_TRUE(holds(sensed, {2.0F, -1.0F, 1.0F}));
  EXPECT_EQ(sensed.stamp_s, 5.0);
}

TEST_F(ObstaclesOfAFrame, AreNotWhatIsFarOrHasNoDepth) {
  frame_.depth_m.at<float>(1, 0) = 0.0F;
  frame_.depth_m.at<float>(1, 2) = 9.0F;
  const auto sensed = sense();
  EXPECT_EQ(sensed.p_base_m.size(), 1U);
  EXPECT_TRUE(holds(sensed, {2.0F, 0.0F, 1.0F}));
}

TEST_F(ObstaclesOfAFrame, MayBeOnlyWhatMayMove) {
  options_.only_moving = true;
  EXPECT_TRUE(sense().p_base_m.empty());
  frame_.mayMove = cv::Mat(3, 3, CV_8UC1, cv::Scalar(0));
  frame_.mayMove.at<std::uint8_t>(1, 2) = 255;
  const auto sensed = sense();
  ASSERT_EQ(sensed.p_base_m.size(), 1U);
  EXPECT_TRUE(holds(sensed, {2.0F, -1.0F, 1.0F}));
}

TEST_F(ObstaclesOfAFrame, WithoutAPoseLieBeforeTheRobotWhereverItIs) {
  Obstacles obstacles(emptyPlan(), options_);
  obstacles.onFrame(frame_, odometry_);
  odometry_.state = odometry::State::Lost;
  frame_.T_base_cam = Eigen::Translation3d(0.2, 0.0, 1.0) * core::T_sensor_cam();
  frame_.stamp_s = 6.0;
  obstacles.onFrame(frame_, odometry_);
  for (const double x_m : {0.0, 3.0}) {
    const auto sensed = obstacles.sense(robotAt(x_m, 1.0, 1.0));
    EXPECT_EQ(sensed.p_base_m.size(), 3U);
    EXPECT_TRUE(holds(sensed, {2.2F, 0.0F, 1.0F}));
    EXPECT_EQ(sensed.stamp_s, 6.0);
  }
  odometry_.state = odometry::State::Ok;
  obstacles.onFrame(frame_, odometry_);
  EXPECT_TRUE(holds(obstacles.sense(robotAt(0.0, 0.0, 0.0)), {2.0F, 0.0F, 1.0F})) << "in the map again";
}

/// A map that leans by 3 degrees has floor 4 m away at z = 0.21 m: no obstacle. A wall there is one.
TEST_F(ObstaclesOfAFrame, AreNotTheFloorOfAMapThatLeans) {
  constexpr double kWall_m = 4.0;
  frame_.camera = {};
  frame_.camera.width_px = 160;
  frame_.camera.height_px = 120;
  frame_.camera.fx_px = frame_.camera.fy_px = 120.0;
  frame_.camera.cx_px = 79.5;
  frame_.camera.cy_px = 59.5;
  frame_.depth_m = cv::Mat(120, 160, CV_32FC1, cv::Scalar(0));
  const Eigen::Isometry3d T_true_cam =
      Eigen::Translation3d(0.0, 0.0, 1.0) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()) * core::T_sensor_cam();
  frame_.depth_m.forEach<float>([&](float& depth_m, const int* at) {
    const Eigen::Vector3d ray = T_true_cam.linear() * frame_.camera.unproject({at[1], at[0]}, 1.0);
    const double wall = kWall_m / ray.x();
    depth_m = static_cast<float>(ray.z() < 0 ? std::min(wall, -1.0 / ray.z()) : wall);
  });
  const Eigen::Isometry3d T_map_true(Eigen::AngleAxisd(-3.0 * M_PI / 180.0, Eigen::Vector3d::UnitY()));
  odometry_.T_map_cam = T_map_true * T_true_cam;
  odometry::Keyframe keyframe;
  keyframe.ground = core::GroundPlane::atZero(T_true_cam);
  odometry_.keyframe = std::make_shared<odometry::Keyframe>(std::move(keyframe));
  options_.max_depth_m = 10.0;
  const auto sensed = sense();
  ASSERT_FALSE(sensed.p_base_m.empty());
  for (const auto& p_map_m : sensed.p_base_m) {
    const Eigen::Vector3d p_true_m = T_map_true.inverse() * p_map_m.cast<double>();
    EXPECT_NEAR(p_true_m.x(), kWall_m, 0.01);
    EXPECT_GT(p_true_m.z(), options_.min_height_m - 0.01);
  }
}

TEST(Obstacles, FillWhatMrptsNavigatorsAskFor) {
  mrpt::maps::CSimplePointsMap points;
  points.insertPoint(7, 7, 7);
  mrpt::Clock::time_point stamp;
  fill({{{1.0F, 2.0F, 0.5F}, {3.0F, 4.0F, 0.25F}}, 1700000000.5}, points, stamp);
  ASSERT_EQ(points.size(), 2U);
  mrpt::math::TPoint3Df second;
  points.getPoint(1, second.x, second.y, second.z);
  EXPECT_EQ(second, mrpt::math::TPoint3Df(3.0F, 4.0F, 0.25F));
  EXPECT_NEAR(core::fromMrptTime(stamp), 1700000000.5, 1e-6);
}

}  // namespace
}  // namespace wardslam::navigation
