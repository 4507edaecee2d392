#include "simulated_robot.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wardslam::nav_demo {
namespace {

constexpr double kStep_s = 0.02;

Eigen::Isometry2d poseAt(double x_m, double y_m, double yaw_rad) {
  return Eigen::Translation2d(x_m, y_m) * Eigen::Rotation2Dd(yaw_rad);
}

TEST(SimulatedRobot, DrivesWhereItLooks) {
  SimulatedRobot robot({}, poseAt(1.0, 2.0, M_PI / 2), 1);
  for (int i = 0; i < 100; ++i) {
    robot.drive(0.5, 0.0);
    robot.step(kStep_s);
  }
  const Eigen::Vector2d p = robot.T_world_robot().translation();
  EXPECT_NEAR(p.x(), 1.0, 1e-6);
  EXPECT_NEAR(p.y(), 3.0, 0.25);  // the wheels lag
  EXPECT_NEAR(robot.forward_mps(), 0.5, 0.01);
}

TEST(SimulatedRobot, StopsBeforeWhatItSees) {
  SimulatedRobot robot({}, poseAt(0.0, 0.0, 0.0), 1);
  for (int i = 0; i < 500; ++i) {
    const double x_m = robot.T_world_robot().translation().x();
    if (i % 5 == 0) robot.see({{2.0 - x_m, 0.1}});
    if (i % 5 == 0) robot.drive(0.6, 0.0);
    robot.step(kStep_s);
  }
  const double gap_m = std::hypot(2.0 - robot.T_world_robot().translation().x(), 0.1) - RobotOptions().radius_m;
  EXPECT_GT(gap_m, 0.02);
  EXPECT_LT(gap_m, 0.15);
}

TEST(SimulatedRobot, PassesWhatIsBeside) {
  SimulatedRobot robot({}, poseAt(0.0, 0.0, 0.0), 1);
  for (int i = 0; i < 500; ++i) {
    const double x_m = robot.T_world_robot().translation().x();
    robot.see({{1.0 - x_m, 0.35}, {-0.3 - x_m, 0.0}});
    robot.drive(0.6, 0.0);
    robot.step(kStep_s);
  }
  EXPECT_GT(robot.T_world_robot().translation().x(), 1.8);
}

TEST(SimulatedRobot, IsSlowNearAnything) {
  SimulatedRobot robot({}, poseAt(0.0, 0.0, 0.0), 1);
  robot.see({{0.0, 0.5}});  // a gap of 0.25 m, half of what it is careful within
  for (int i = 0; i < 100; ++i) {
    robot.drive(0.6, 0.0);
    robot.step(kStep_s);
  }
  EXPECT_NEAR(robot.forward_mps(), 0.3, 0.01);
}

TEST(SimulatedRobot, KnowsItsPlaceUpToNoise) {
  SimulatedRobot robot({}, poseAt(1.0, 2.0, 0.5), 1);
  double sum2_m2 = 0.0;
  constexpr int kFixes = 500;
  for (int i = 0; i < kFixes; ++i) sum2_m2 += (robot.fix().translation() - Eigen::Vector2d(1.0, 2.0)).squaredNorm();
  EXPECT_NEAR(std::sqrt(sum2_m2 / (2 * kFixes)), RobotOptions().fixSigma_m, 0.001);
}

}  // namespace
}  // namespace wardslam::nav_demo
