#include "wardslam/odometry/map_update.h"

#include <gtest/gtest.h>

namespace wardslam::odometry {
namespace {

// Two keyframes ahead of a mapper that lags: whichever is the newest it knows, the other one follows.
TEST(MapUpdate, WhatFollowsCorrectionsForLongStaysRigid) {
  const Eigen::Isometry3d turn(Eigen::AngleAxisd(1e-3, Eigen::Vector3d(1, 2, 2) / 3));
  Eigen::Isometry3d T_map_newest(Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitX()));
  Eigen::Isometry3d T_map_younger(Eigen::AngleAxisd(-1.2, Eigen::Vector3d::UnitY()));
  for (int i = 0; i < 200; ++i) {
    MapUpdate update;
    update.newestKeyframe = 1;
    update.T_map_cam[1] = turn * T_map_newest;
    T_map_younger = correctionOf(update, T_map_newest) * T_map_younger;
    T_map_newest = update.T_map_cam[1];
    std::swap(T_map_newest, T_map_younger);
  }
  const Eigen::Matrix3d R = T_map_newest.linear();
  EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-12);
}

}  // namespace
}  // namespace wardslam::odometry
