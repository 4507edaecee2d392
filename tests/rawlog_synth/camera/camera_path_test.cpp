#include "camera/camera_path.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wardslam::synth {
namespace {

constexpr double kStep_s = 1.0 / 30;

TEST(CameraPath, CoversFiveMetresInTwentySeconds) {
  const CameraPath path;
  double length_m = 0.0;
  for (double t = 0; t < 20.0; t += kStep_s) {
    length_m += (path.T_world_cam(t + kStep_s).translation() - path.T_world_cam(t).translation()).norm();
  }
  EXPECT_GT(length_m, 5.0);
}

TEST(CameraPath, KeepsToTheAisleAtARobotsHeight) {
  const CameraPath path;
  for (double t = 0; t < path.period_s; t += 0.1) {
    const Eigen::Vector3d p = path.T_world_cam(t).translation();
    EXPECT_GT(p.x(), 1.0);
    EXPECT_LT(p.x(), 7.5);
    EXPECT_GT(p.y(), 2.4) << "beds end at 2.25";
    EXPECT_LT(p.y(), 4.0) << "beds begin at 4.1";
    EXPECT_NEAR(p.z(), 1.1, 0.02);
  }
}

TEST(CameraPath, IsSmooth) {
  const CameraPath path;
  for (double t = 0; t < path.period_s; t += kStep_s) {
    const Eigen::Isometry3d step = path.T_world_cam(t).inverse() * path.T_world_cam(t + kStep_s);
    const Eigen::Isometry3d next = path.T_world_cam(t + kStep_s).inverse() * path.T_world_cam(t + 2 * kStep_s);
    EXPECT_LT(step.translation().norm() / kStep_s, 0.6);
    EXPECT_LT(Eigen::AngleAxisd(step.linear()).angle() / kStep_s, 0.8);
    EXPECT_LT((next.translation() - step.translation()).norm() / (kStep_s * kStep_s), 0.6);
  }
}

TEST(CameraPath, LooksAheadAndAllRound) {
  const CameraPath path;
  int east = 0;
  int west = 0;
  for (double t = 0; t < path.period_s; t += 0.5) {
    const Eigen::Matrix3d R = path.T_world_cam(t).linear();
    EXPECT_NEAR(R.determinant(), 1.0, 1e-12);
    EXPECT_LT(R.col(1).z(), -0.95) << "image rows point to the floor";
    EXPECT_LT(R.col(2).z(), 0.0) << "it looks a little down";
    east += R.col(2).x() > 0.7 ? 1 : 0;
    west += R.col(2).x() < -0.7 ? 1 : 0;
  }
  EXPECT_GT(east, 10);
  EXPECT_GT(west, 10);
}

TEST(CameraPath, Closes) {
  const CameraPath path;
  EXPECT_TRUE(path.T_world_cam(1.0).isApprox(path.T_world_cam(1.0 + path.period_s), 1e-9));
}

}  // namespace
}  // namespace wardslam::synth
