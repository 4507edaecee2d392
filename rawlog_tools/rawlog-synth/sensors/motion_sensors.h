#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <opencv2/core.hpp>

/// What a robot's wheels and an inertial sensor say of its motion.
namespace wardslam::synth {

using PoseAt = std::function<Eigen::Isometry3d(double t_s)>;

/// Pose of a base on the floor: x, y (m) and heading (rad, not wrapped).
using PlanarPose = Eigen::Vector3d;

/// Position and heading of a pose as seen from above.
[[nodiscard]] PlanarPose fromAbove(const Eigen::Isometry3d& T_world_base);

struct OdometryOptions {
  double rate_hz = 20.0;
  double noise = 1.0;  ///< Times all errors; 0: the base's motion as it is.
  // Systematic, drawn once per robot: wheels of other diameter, another wheel base than believed (Borenstein and Feng,
  // "Measurement and correction of systematic odometry errors in mobile robots", 1996).
  double scaleSigma = 0.01;
  double turnScaleSigma = 0.02;
  double veerSigma_rad_per_m = 0.005;
  // Random, with the square root of the way: σ² grows with what was driven (Thrun, Burgard, Fox, "Probabilistic
  // robotics", chapter 5.4).
  double alongSigma_m = 0.01;       ///< After one metre.
  double headingSigma_rad = 0.006;  ///< After one metre.
  double turnSigma_rad = 0.01;      ///< After one radian.
  // Wheels that spin for a moment: on average once in so many metres they turn farther than the base moves.
  double slipEvery_m = 15.0;
  double slipLongest_s = 0.6;
  double slipMost = 0.6;  ///< Turned too far, as a part of what is driven.
  double slipTurnSigma_rad_per_m = 0.15;
};

struct OdometryReading {
  double t_s = 0.0;
  PlanarPose pose = PlanarPose::Zero();                ///< In the frame of the base at the start.
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s, m/s, rad/s in the frame of the base.
};

/// Odometry of wheels that can drive and turn in any direction, reading after reading.
class WheelOdometry {
 public:
  WheelOdometry(PoseAt T_world_base, const OdometryOptions& options, std::uint32_t seed);
  /// The first is at t = 0, where the odometry's frame is.
  [[nodiscard]] OdometryReading next();
  [[nodiscard]] double nextStamp_s() const;

 private:
  [[nodiscard]] Eigen::Vector3d felt(const Eigen::Vector3d& step);

  PoseAt T_world_base_;
  OdometryOptions options_;
  cv::RNG rng_;
  double scale_ = 0.0;
  double turnScale_ = 0.0;
  double veer_rad_per_m_ = 0.0;
  double slipLeft_s_ = 0.0;
  double slip_ = 0.0;
  double slipTurn_rad_per_m_ = 0.0;
  std::int64_t count_ = 0;
  PlanarPose truth_ = PlanarPose::Zero();
  OdometryReading reading_;
};

/// Angular velocity and specific force with white noise and wandering biases; the figures are those of the EuRoC data
/// sets' ADIS16448 (Burri et al., 2016).
struct ImuOptions {
  double rate_hz = 100.0;
  double noise = 1.0;              ///< Times all errors, biases too.
  double gyroNoise = 1.7e-4;       ///< rad/s/√Hz
  double gyroWalk = 1.9e-5;        ///< rad/s²/√Hz
  double accelNoise = 2.0e-3;      ///< m/s²/√Hz
  double accelWalk = 3.0e-3;       ///< m/s³/√Hz
  double gyroBiasSigma = 3.0e-3;   ///< rad/s, when it is switched on.
  double accelBiasSigma = 5.0e-2;  ///< m/s²
};

struct ImuReading {
  double t_s = 0.0;
  Eigen::Vector3d angularVelocity = Eigen::Vector3d::Zero();  ///< rad/s, sensor frame.
  Eigen::Vector3d specificForce = Eigen::Vector3d::Zero();  ///< m/s², sensor frame: with gravity, 9.81 upwards at rest.
};

constexpr double kGravity_mps2 = 9.81;

/// Each reading is the mean over its period (as chips low-pass), so that summing them up gives the motion back.
class Imu {
 public:
  /// `T_world_imu` is asked from one period before the start on.
  Imu(PoseAt T_world_imu, const ImuOptions& options, std::uint32_t seed);
  /// The first is at t = 0.
  [[nodiscard]] ImuReading next();
  [[nodiscard]] double nextStamp_s() const { return static_cast<double>(count_) / options_.rate_hz; }

 private:
  PoseAt T_world_imu_;
  ImuOptions options_;
  cv::RNG rng_;
  Eigen::Vector3d gyroBias_;
  Eigen::Vector3d accelBias_;
  std::int64_t count_ = 0;
};

}  // namespace wardslam::synth
