#include "people/walker.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace wardslam::synth {
namespace {

constexpr double kStep_s = 0.01;
constexpr double kTurnTime_s = 0.25;  ///< Lag of the heading behind the direction of motion.
constexpr double kStanding_mps = 0.02;
constexpr double kFacing_radps = 0.03;

/// Slope at a knot between two secants: Fritsch–Butland, which keeps the curve monotone between knots.
double slope(double before, double after) { return before * after <= 0 ? 0.0 : 2 * before * after / (before + after); }

Eigen::Vector2d secant(const std::vector<Waypoint>& route, std::size_t i) {
  return (route[i + 1].p_m - route[i].p_m) / (route[i + 1].t_s - route[i].t_s);
}

/// Velocity at waypoint i: zero at both ends.
Eigen::Vector2d velocityAt(const std::vector<Waypoint>& route, std::size_t i) {
  if (i == 0 || i + 1 == route.size()) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d before = secant(route, i - 1);
  const Eigen::Vector2d after = secant(route, i);
  return {slope(before.x(), after.x()), slope(before.y(), after.y())};
}

Eigen::Vector2d positionAt(const std::vector<Waypoint>& route, double t_s) {
  const auto next = std::upper_bound(route.begin(), route.end(), t_s,
                                     [](double t, const Waypoint& waypoint) { return t < waypoint.t_s; });
  if (next == route.begin()) return route.front().p_m;
  if (next == route.end()) return route.back().p_m;
  const auto i = static_cast<std::size_t>(next - route.begin()) - 1;
  const double h = route[i + 1].t_s - route[i].t_s;
  const double s = (t_s - route[i].t_s) / h;
  return (1 + 2 * s) * (1 - s) * (1 - s) * route[i].p_m + s * (1 - s) * (1 - s) * h * velocityAt(route, i) +
         s * s * (3 - 2 * s) * route[i + 1].p_m + s * s * (s - 1) * h * velocityAt(route, i + 1);
}

/// `angle` shifted by whole turns to lie within half a turn of `reference`.
double nearestTurn(double angle, double reference) { return reference + std::remainder(angle - reference, 2 * M_PI); }

void requireUsable(const std::vector<Waypoint>& route, double loopFrom_s) {
  if (route.size() < 2) throw std::invalid_argument("a route needs two waypoints");
  for (std::size_t i = 1; i < route.size(); ++i) {
    if (route[i].t_s <= route[i - 1].t_s) throw std::invalid_argument("the times of a route must increase");
  }
  if (loopFrom_s >= route.back().t_s || (positionAt(route, loopFrom_s) - route.back().p_m).norm() > 1e-9) {
    throw std::invalid_argument("a route must end where its loop begins");
  }
}

}  // namespace

Walker::Walker(const std::vector<Waypoint>& route, double loopFrom_s)
    : end_s_(route.empty() ? 0.0 : route.back().t_s), loop_s_(end_s_ - loopFrom_s) {
  requireUsable(route, loopFrom_s);
  const auto steps = static_cast<std::size_t>(std::ceil((end_s_ + loop_s_) / kStep_s)) + 2;
  const auto wrapped = [&](double t) { return t <= end_s_ ? t : loopFrom_s + std::fmod(t - end_s_, loop_s_); };

  const Eigen::Vector2d firstStep = route[1].p_m - route[0].p_m;
  double heading = std::atan2(firstStep.y(), firstStep.x());
  double walked = 0.0;
  for (std::size_t i = 0; i < steps; ++i) {
    const double t = static_cast<double>(i) * kStep_s;
    const Eigen::Vector2d p = positionAt(route, wrapped(t));
    const Eigen::Vector2d v = (positionAt(route, wrapped(t + kStep_s)) - p) / kStep_s;
    const double speed = v.norm();
    double turned = 0.0;
    if (speed > kStanding_mps) {
      turned = (nearestTurn(std::atan2(v.y(), v.x()), heading) - heading) * kStep_s / kTurnTime_s;
      turned *= std::min(1.0, speed / 0.3);  // nobody spins round while hardly moving
    }
    const bool moving = speed > kStanding_mps || std::abs(turned) / kStep_s > kFacing_radps;
    table_.push_back({p, heading, speed, walked, moving});
    heading += turned;
    walked += speed * kStep_s;
  }
}

Gait Walker::at(double t_s) const {
  const double t = t_s <= end_s_ ? std::max(t_s, 0.0) : end_s_ + std::fmod(t_s - end_s_, loop_s_);
  const double index = t / kStep_s;
  const auto i = std::min(static_cast<std::size_t>(index), table_.size() - 2);
  const double w = index - static_cast<double>(i);
  const auto mix = [w](auto a, auto b) { return (1 - w) * a + w * b; };
  const Gait& a = table_[i];
  const Gait& b = table_[i + 1];
  Gait gait;
  gait.p_m = a.p_m + w * (b.p_m - a.p_m);
  gait.heading_rad = mix(a.heading_rad, b.heading_rad);
  gait.speed_mps = mix(a.speed_mps, b.speed_mps);
  gait.walked_m = mix(a.walked_m, b.walked_m);
  gait.moving = a.moving || b.moving;
  return gait;
}

}  // namespace wardslam::synth
