#include "constant_velocity.h"

#include <algorithm>

namespace wardslam::odometry {
namespace {

constexpr double kLongest_s = 0.5;
constexpr double kAcceleration_mps2 = 1.0;
constexpr double kTurning_radps2 = 4.0;
constexpr double kAnySpeed_mps = 1.0;
constexpr double kAnyTurn_radps = 1.0;
constexpr double kLeast_m = 0.003;  // of the poses that the velocity comes from
constexpr double kLeast_rad = 0.003;

double squared(double x) { return x * x; }

PoseCovariance isotropic(double translation_m, double rotation_rad) {
  PoseCovariance covariance = PoseCovariance::Zero();
  covariance.diagonal().head<3>().setConstant(squared(translation_m));
  covariance.diagonal().tail<3>().setConstant(squared(rotation_rad));
  return covariance;
}

PoseCovariance covarianceAfter(double seconds) {
  return isotropic(kLeast_m + 0.5 * kAcceleration_mps2 * seconds * seconds,
                   kLeast_rad + 0.5 * kTurning_radps2 * seconds * seconds);
}

}  // namespace

void ConstantVelocity::observe(const Eigen::Isometry3d& T_now_before, double since_s, bool isSure) {
  if (!(since_s > 0.0)) {
    forget();
    return;
  }
  unsureFor_s_ = isSure ? 0.0 : unsureFor_s_ + since_s;
  twist_ = twistOf(T_now_before.inverse(), since_s);
}

MotionPrior ConstantVelocity::predict(double ahead_s) const {
  MotionPrior motion;
  const double seconds = std::max(0.0, ahead_s);
  if (!twist_) {
    motion.covariance = isotropic(kLeast_m + kAnySpeed_mps * seconds, kLeast_rad + kAnyTurn_radps * seconds);
    return motion;
  }
  motion.covariance = covarianceAfter(unsureFor_s_ + seconds);
  if (unsureFor_s_ > 0.0) motion.covariance -= covarianceAfter(unsureFor_s_);
  motion.covariance.diagonal().array() += squared(1e-4);
  motion.T_previous_now = after(*twist_, std::min(seconds, kLongest_s));
  return motion;
}

}  // namespace wardslam::odometry
