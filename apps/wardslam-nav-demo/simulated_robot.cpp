#include "simulated_robot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "random_numbers.h"

namespace wardslam::nav_demo {
namespace {

constexpr double kLooksAhead_s = 2.0;
constexpr double kStep_s = 0.05;

Eigen::Isometry2d movedBy(double forward_mps, double turn_radps, double t_s) {
  const double angle = turn_radps * t_s;
  const double along = forward_mps * t_s;
  const double halfChord = std::abs(angle) < 1e-6 ? 1.0 : std::sin(angle / 2) / (angle / 2);
  return Eigen::Translation2d(along * halfChord * std::cos(angle / 2), along * halfChord * std::sin(angle / 2)) *
         Eigen::Rotation2Dd(angle);
}

/// The speed v from which it stops within a way: way = v reaction + v^2 / (2 braking).
double stoppableSpeed_mps(double way_m, const RobotOptions& options) {
  const double lost_mps = options.braking_mps2 * (options.lag_s + options.scanPeriod_s);
  return std::sqrt(lost_mps * lost_mps + 2.0 * options.braking_mps2 * way_m) - lost_mps;
}

}  // namespace

SimulatedRobot::SimulatedRobot(const RobotOptions& options, const Eigen::Isometry2d& T_world_robot, std::uint32_t seed)
    : options_(options), random_(seed) {
  vehicle_.resetStatus();
  vehicle_.resetTime();
  vehicle_.setDelayModelParams(options.lag_s, 0.0);
  const Eigen::Vector2d p = T_world_robot.translation();
  vehicle_.setCurrentGTPose({p.x(), p.y(), Eigen::Rotation2Dd(T_world_robot.linear()).angle()});
}

Eigen::Isometry2d SimulatedRobot::T_world_robot() const {
  const auto& pose = vehicle_.getCurrentGTPose();
  return Eigen::Translation2d(pose.x, pose.y) * Eigen::Rotation2Dd(pose.phi);
}

Eigen::Isometry2d SimulatedRobot::fix() {
  const double x_m = gaussian(random_, options_.fixSigma_m);
  const double y_m = gaussian(random_, options_.fixSigma_m);
  const double turn_rad = gaussian(random_, options_.fixSigma_rad);
  return T_world_robot() * Eigen::Translation2d(x_m, y_m) * Eigen::Rotation2Dd(turn_rad);
}

/// Of a speed as much as lets the robot stop before what it would come near to.
double SimulatedRobot::safeShare(double forward_mps, double turn_radps) const {
  const double near_m = options_.radius_m + options_.keepsOff_m;
  double share = 1.0;
  for (const auto& p : scan_m_) {
    double before_m = p.norm();
    for (double t_s = kStep_s; t_s <= kLooksAhead_s; t_s += kStep_s) {
      const double off_m = (p - movedBy(forward_mps, turn_radps, t_s).translation()).norm();
      if (off_m >= before_m) break;  // passed
      before_m = off_m;
      if (off_m > near_m) continue;
      const double way_m = std::abs(forward_mps) * (t_s - kStep_s);
      share = std::min(share, stoppableSpeed_mps(way_m, options_) / std::abs(forward_mps));
      break;
    }
  }
  return share;
}

/// Slower near anything: people may come nearer while it stops.
double SimulatedRobot::carefulShare() const {
  double gap_m = options_.carefulWithin_m;
  for (const auto& p : scan_m_) gap_m = std::min(gap_m, p.norm() - options_.radius_m);
  return std::max(options_.slowestShare, gap_m / options_.carefulWithin_m);
}

void SimulatedRobot::drive(double forward_mps, double turn_radps) {
  const double share =
      std::abs(forward_mps) > 1e-3 ? std::min(carefulShare(), safeShare(forward_mps, turn_radps)) : 1.0;
  vehicle_.movementCommand(share * forward_mps, share * turn_radps);
}

}  // namespace wardslam::nav_demo
