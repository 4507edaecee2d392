#pragma once

#include <gtest/gtest.h>

#include "odometry/synthetic_world.h"
#include "wardslam/odometry/odometry.h"

namespace wardslam::odometry {

using test::Noise;
using test::SyntheticWorld;

inline constexpr int kImages = 60;
inline constexpr Noise kNoise{0.5, 1.0, 8};

inline Eigen::Isometry3d truth(int image) {
  return SyntheticWorld::T_world_cam(0, kImages).inverse() * SyntheticWorld::T_world_cam(image, kImages);
}

inline double distance_m(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.translation() - b.translation()).norm();
}

inline double angle_deg(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle() * 180 / M_PI;
}

/// A camera on a known path among points with known descriptors.
class OdometryTest : public ::testing::Test {
 protected:
  OdometryResult trackImage(int image, const Noise& noise = kNoise) {
    return track(world_.look(SyntheticWorld::T_world_cam(image, kImages), noise));
  }
  OdometryResult track(const core::Features& features) {
    return odometry_.track(stamp_s_ += 1.0 / 30, SyntheticWorld::camera(), features);
  }

  static OdometryOptions options() {
    OdometryOptions options;
    options.min_initial_points = 80;
    options.max_lost_frames = 5;
    return options;
  }

  SyntheticWorld world_;
  Odometry odometry_{options()};
  double stamp_s_ = 0;
};

}  // namespace wardslam::odometry
