#include "sensors/motion_sensors.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wardslam::synth {
namespace {

Eigen::Vector3d gaussian3(cv::RNG& rng, double sigma) {
  const double x = rng.gaussian(sigma);
  const double y = rng.gaussian(sigma);
  return {x, y, rng.gaussian(sigma)};
}

/// Motion from a to b in the frame of a.
Eigen::Vector3d stepBetween(const PlanarPose& a, const PlanarPose& b) {
  const double turn = std::remainder(b.z() - a.z(), 2 * M_PI);
  const Eigen::Vector2d p = Eigen::Rotation2Dd(-a.z()) * (b - a).head<2>();
  return {p.x(), p.y(), turn};
}

PlanarPose composed(const PlanarPose& a, const Eigen::Vector3d& step) {
  PlanarPose b = a;
  b.head<2>() += Eigen::Rotation2Dd(a.z()) * step.head<2>();
  b.z() += step.z();
  return b;
}

}  // namespace

PlanarPose fromAbove(const Eigen::Isometry3d& T_world_base) {
  const auto& R = T_world_base.linear();
  return {T_world_base.translation().x(), T_world_base.translation().y(), std::atan2(R(1, 0), R(0, 0))};
}

WheelOdometry::WheelOdometry(PoseAt T_world_base, const OdometryOptions& options, std::uint32_t seed)
    : T_world_base_(std::move(T_world_base)),
      options_(options),
      rng_((static_cast<std::uint64_t>(seed) << 32U) + 0x0D0U),
      scale_(rng_.gaussian(options.noise * options.scaleSigma)),
      turnScale_(rng_.gaussian(options.noise * options.turnScaleSigma)),
      veer_rad_per_m_(rng_.gaussian(options.noise * options.veerSigma_rad_per_m)),
      truth_(fromAbove(T_world_base_(0.0))) {}

double WheelOdometry::nextStamp_s() const { return static_cast<double>(count_) / options_.rate_hz; }

OdometryReading WheelOdometry::next() {
  reading_.t_s = nextStamp_s();
  if (count_++ > 0) {
    const PlanarPose now = fromAbove(T_world_base_(reading_.t_s));
    const Eigen::Vector3d step = felt(stepBetween(truth_, now));
    truth_ = now;
    reading_.pose = composed(reading_.pose, step);
    reading_.velocity = step * options_.rate_hz;
  }
  return reading_;
}

Eigen::Vector3d WheelOdometry::felt(const Eigen::Vector3d& step) {
  const double noise = options_.noise;
  const double way_m = step.head<2>().norm();
  const double turn_rad = std::abs(step.z());
  if (rng_.uniform(0.0, 1.0) < way_m / options_.slipEvery_m) {
    slipLeft_s_ = rng_.uniform(0.2, 1.0) * options_.slipLongest_s;
    slip_ = noise * rng_.uniform(0.2, 1.0) * options_.slipMost;
    slipTurn_rad_per_m_ = rng_.gaussian(noise * options_.slipTurnSigma_rad_per_m);
  }
  const bool slips = slipLeft_s_ > 0;
  slipLeft_s_ -= 1.0 / options_.rate_hz;
  const double along = 1.0 + scale_ + (slips ? slip_ : 0.0);
  Eigen::Vector3d out = step;
  out.head<2>() *= along;
  out.x() += rng_.gaussian(noise * options_.alongSigma_m * std::sqrt(way_m));
  out.z() += turnScale_ * step.z() + (veer_rad_per_m_ + (slips ? slipTurn_rad_per_m_ : 0.0)) * way_m;
  out.z() += rng_.gaussian(
      noise * std::hypot(options_.headingSigma_rad * std::sqrt(way_m), options_.turnSigma_rad * std::sqrt(turn_rad)));
  return out;
}

Imu::Imu(PoseAt T_world_imu, const ImuOptions& options, std::uint32_t seed)
    : T_world_imu_(std::move(T_world_imu)),
      options_(options),
      rng_((static_cast<std::uint64_t>(seed) << 32U) + 0x1330U),
      gyroBias_(gaussian3(rng_, options.noise * options.gyroBiasSigma)),
      accelBias_(gaussian3(rng_, options.noise * options.accelBiasSigma)) {}

ImuReading Imu::next() {
  const double period_s = 1.0 / options_.rate_hz;
  ImuReading reading;
  reading.t_s = nextStamp_s();
  ++count_;
  const Eigen::Isometry3d before = T_world_imu_(reading.t_s - period_s);
  const Eigen::Isometry3d now = T_world_imu_(reading.t_s);
  const Eigen::Isometry3d after = T_world_imu_(reading.t_s + period_s);
  const auto halfway = [&](double side) -> Eigen::Matrix3d {
    return T_world_imu_(reading.t_s + side * period_s / 2).linear();
  };
  const Eigen::Matrix3d rotation = halfway(-1).transpose() * halfway(1);
  const Eigen::AngleAxisd turn(rotation);
  const Eigen::Vector3d acceleration =
      (after.translation() - 2 * now.translation() + before.translation()) / (period_s * period_s);

  const double perSample = options_.noise * std::sqrt(options_.rate_hz);
  const double walked = options_.noise * std::sqrt(period_s);
  gyroBias_ += gaussian3(rng_, walked * options_.gyroWalk);
  accelBias_ += gaussian3(rng_, walked * options_.accelWalk);
  reading.angularVelocity =
      turn.angle() * turn.axis() / period_s + gyroBias_ + gaussian3(rng_, perSample * options_.gyroNoise);
  reading.specificForce = now.linear().transpose() * (acceleration + kGravity_mps2 * Eigen::Vector3d::UnitZ()) +
                          accelBias_ + gaussian3(rng_, perSample * options_.accelNoise);
  return reading;
}

}  // namespace wardslam::synth
