#include "sensors/motion_sensors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "camera/camera_mount.h"
#include "camera/camera_path.h"
#include "places/floor_scene.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::synth {
namespace {

const Eigen::Isometry3d kT_base_sensor = T_base_sensor(CameraMount{});

Eigen::Isometry3d T_world_sensor(double t_s) { return FloorPath().T_world_cam(t_s) * core::T_sensor_cam().inverse(); }
Eigen::Isometry3d T_world_base(double t_s) { return T_world_sensor(t_s) * kT_base_sensor.inverse(); }

TEST(CameraMount, TheBaseUnderTheCameraDrivesOnTheFloor) {
  for (double t_s = 0; t_s < 60; t_s += 0.5) {
    const Eigen::Isometry3d T = T_world_base(t_s);
    EXPECT_NEAR(T.translation().z(), 0.0, 0.02);
    EXPECT_GT(T.linear()(2, 2), std::cos(0.06)) << "it rocks by less than 3.5 degrees";
    EXPECT_LT((T.translation() - T_world_sensor(t_s).translation()).head<2>().norm(), 0.07);
  }
}

TEST(WheelOdometry, WithoutNoiseIsTheBasesMotion) {
  OdometryOptions options;
  options.noise = 0.0;
  WheelOdometry odometry(T_world_base, options, 1);
  const PlanarPose start = fromAbove(T_world_base(0.0));
  for (int i = 0; i <= 1200; ++i) {  // a round of 60 s
    EXPECT_DOUBLE_EQ(odometry.nextStamp_s(), i / 20.0);
    const OdometryReading reading = odometry.next();
    const PlanarPose truth = fromAbove(T_world_base(reading.t_s));
    const Eigen::Vector2d p = start.head<2>() + Eigen::Rotation2Dd(start.z()) * reading.pose.head<2>();
    ASSERT_LT((p - truth.head<2>()).norm(), 1e-9);
    ASSERT_LT(std::abs(std::remainder(start.z() + reading.pose.z() - truth.z(), 2 * M_PI)), 1e-9);
  }
}

TEST(WheelOdometry, SpeedsAreThoseOfTheBase) {
  OdometryOptions options;
  options.noise = 0.0;
  WheelOdometry odometry(
      [](double t_s) -> Eigen::Isometry3d {
        return Eigen::AngleAxisd(0.5 * t_s, Eigen::Vector3d::UnitZ()) * Eigen::Translation3d(0.0, -1.6, 0.0);
      },
      options, 1);
  static_cast<void>(odometry.next());
  const OdometryReading reading = odometry.next();
  // A circle of 1.6 m at 0.5 rad/s, forwards.
  EXPECT_NEAR(reading.velocity.x(), 0.8, 1e-3);
  EXPECT_NEAR(reading.velocity.z(), 0.5, 1e-9);
}

TEST(WheelOdometry, DriftsBySomeParts) {
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    WheelOdometry odometry(T_world_base, {}, seed);
    OdometryReading reading;
    for (int i = 0; i <= 1200; ++i) reading = odometry.next();
    const double off_m = reading.pose.head<2>().norm();  // the round closes
    EXPECT_GT(off_m, 0.02);
    EXPECT_LT(off_m, 8.0) << "of 41 m";
  }
}

TEST(WheelOdometry, NearlyStillOnlyWhenTheBaseIs) {
  WheelOdometry odometry([](double) { return Eigen::Isometry3d::Identity(); }, {}, 1);
  OdometryReading reading;
  for (int i = 0; i < 200; ++i) reading = odometry.next();
  EXPECT_LT(reading.pose.norm(), 1e-12);
}

TEST(Imu, WithoutNoiseItsSumIsTheMotion) {
  ImuOptions options;
  options.noise = 0.0;
  options.rate_hz = 200.0;
  Imu imu(T_world_sensor, options, 1);
  const double period_s = 1 / options.rate_hz;
  const Eigen::Vector3d gravity(0, 0, -kGravity_mps2);
  Eigen::Matrix3d R = T_world_sensor(-period_s / 2).linear();
  Eigen::Vector3d p = T_world_sensor(0.0).translation();
  Eigen::Vector3d v = (p - T_world_sensor(-period_s).translation()) / period_s;
  for (int i = 0; i < 2000; ++i) {
    const ImuReading reading = imu.next();
    const Eigen::Vector3d turn = reading.angularVelocity * period_s;
    const auto rotation = [&](double part) -> Eigen::Matrix3d {
      return Eigen::AngleAxisd(part * turn.norm(), turn.normalized()).toRotationMatrix();
    };
    const Eigen::Matrix3d middle = R * rotation(0.5);
    R = R * rotation(1.0);
    v += (middle * reading.specificForce + gravity) * period_s;
    p += v * period_s;
  }
  const Eigen::Isometry3d end = T_world_sensor(10.0);
  EXPECT_LT((p - end.translation()).norm(), 0.01) << "after 10 s";
  EXPECT_LT(Eigen::AngleAxisd(Eigen::Matrix3d(R.transpose() * T_world_sensor(10.0 - period_s / 2).linear())).angle(),
            1e-9);
}

TEST(Imu, AtRestFeelsGravityUpwardsAndItsOwnErrors) {
  constexpr int kReadings = 2000;
  Imu imu([](double) { return Eigen::Isometry3d::Identity(); }, {}, 4);
  Eigen::Vector3d turned = Eigen::Vector3d::Zero();
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  double gyroSquares = 0.0;
  for (int i = 0; i < kReadings; ++i) {
    const ImuReading reading = imu.next();
    turned += reading.angularVelocity / kReadings;
    force += reading.specificForce / kReadings;
    gyroSquares += reading.angularVelocity.squaredNorm() / 3 / kReadings;
  }
  EXPECT_NEAR(force.z(), 9.81, 0.2);
  EXPECT_LT(force.head<2>().norm(), 0.2);
  EXPECT_GT((force - Eigen::Vector3d(0, 0, 9.81)).norm(), 1e-3) << "the bias";
  EXPECT_GT(turned.norm(), 1e-4) << "the bias";
  EXPECT_LT(turned.norm(), 0.015);
  // White noise of 1.7e-4 rad/s/√Hz at 100 Hz.
  EXPECT_NEAR(std::sqrt(gyroSquares - turned.squaredNorm() / 3), 1.7e-3, 3e-4);
}

}  // namespace
}  // namespace wardslam::synth
