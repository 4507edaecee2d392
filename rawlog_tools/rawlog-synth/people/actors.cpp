#include "people/actors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "furniture/furniture.h"
#include "people/anatomy.h"

namespace wardslam::synth {
namespace {

constexpr double kGrip_s = 0.4;
constexpr double kBriskWalk_mps = 1.0;

Eigen::Isometry3d T_world_walker(const Gait& gait) {
  return Eigen::Translation3d(gait.p_m.x(), gait.p_m.y(), 0.0) *
         Eigen::AngleAxisd(gait.heading_rad, Eigen::Vector3d::UnitZ());
}

}  // namespace

PersonActor::PersonActor(Label label, Walker walker, Look look, PushingTime pushing)
    : Actor(std::move(label)), walker_(std::move(walker)), look_(look), pushing_(pushing) {}

double PersonActor::reachingAt(double t_s) const {
  if (pushing_.until_s <= pushing_.from_s) return 0.0;
  const double grip = (t_s - pushing_.from_s) / kGrip_s + 1.0;
  const double release = (pushing_.until_s - t_s) / kGrip_s + 1.0;
  return std::clamp(std::min(grip, release), 0.0, 1.0);
}

Surfaces PersonActor::surfacesAt(double t_s) const {
  const Gait gait = walker_.at(t_s);
  Posture posture;
  posture.stride_rad = 2 * M_PI * gait.walked_m / anatomy::strideLength_m(look_.height_m);
  posture.swing = std::min(1.0, gait.speed_mps / kBriskWalk_mps);
  posture.reaching = reachingAt(t_s);
  return placed({{look_.outfit, posePerson(look_, posture)}}, T_world_walker(gait).cast<float>());
}

bool PersonActor::isMovingAt(double t_s) const {
  const double reaching = reachingAt(t_s);
  return walker_.at(t_s).moving || (reaching > 0.0 && reaching < 1.0);
}

Eigen::AlignedBox3f PersonActor::boundsAt(double t_s) const {
  constexpr float kReachAround_m = 1.2F;  // strides and outstretched arms
  constexpr float kHighest_m = 2.4F;
  const Eigen::Vector2f p = walker_.at(t_s).p_m.cast<float>();
  return {Eigen::Vector3f(p.x() - kReachAround_m, p.y() - kReachAround_m, 0),
          Eigen::Vector3f(p.x() + kReachAround_m, p.y() + kReachAround_m, kHighest_m)};
}

double PersonActor::atRestFrom_s() const { return std::numeric_limits<double>::infinity(); }

TrolleyActor::TrolleyActor(Label label, Walker pusher, double until_s, Surfaces model)
    : Actor(std::move(label)), pusher_(std::move(pusher)), until_s_(until_s), model_(std::move(model)) {}

Eigen::Isometry3d TrolleyActor::T_world_trolley(double t_s) const {
  const Gait gait = pusher_.at(std::min(t_s, until_s_));
  return T_world_walker(gait) * Eigen::Translation3d(anatomy::kReach_m - kTrolleyHandleX_m, 0.0, 0.0);
}

Surfaces TrolleyActor::surfacesAt(double t_s) const { return placed(model_, T_world_trolley(t_s).cast<float>()); }

bool TrolleyActor::isMovingAt(double t_s) const { return t_s < until_s_ && pusher_.at(t_s).moving; }

}  // namespace wardslam::synth
