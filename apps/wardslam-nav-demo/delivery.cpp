#include "delivery.h"

#include <algorithm>
#include <cmath>

#include "wardslam/query/route.h"

namespace wardslam::nav_demo {
namespace {

constexpr double kArrives_m = 0.08;
constexpr double kIsThere_m = 0.15;
constexpr double kHeadway_m = 0.15;  ///< It must get so far
constexpr double kPatience_s = 3.0;  ///< in so much time, or plans anew.
constexpr double kTriesAgain_s = 1.0;
constexpr double kTurnsFirst_rad = 0.8;  ///< It drives off only when the way lies ahead.
constexpr double kTurned_rad = 0.3;
constexpr double kFaces_rad = 0.03;
constexpr double kGain_perS = 2.0;
constexpr double kFastestTurn_radps = 0.9;
constexpr double kSlowestTurn_radps = 0.08;

double wrapped_rad(double angle) { return std::remainder(angle, 2.0 * M_PI); }

double yawOf_rad(const Eigen::Isometry2d& T) { return Eigen::Rotation2Dd(T.linear()).angle(); }

/// The plan with what is seen now, as far as it is near: what is far will have moved when the robot gets there.
mapping::FloorPlan withSeen(const mapping::FloorPlan& plan, const std::vector<Eigen::Vector2d>& seen_map_m,
                            const Eigen::Vector2d& here_m) {
  constexpr double kNear_m = 2.5;
  mapping::FloorPlan now{plan.cells.clone(), plan.resolution_m, plan.origin_m};
  for (const auto& p_m : seen_map_m) {
    const Eigen::Array2d cell = ((p_m - plan.origin_m) / plan.resolution_m).array().floor();
    if ((p_m - here_m).norm() > kNear_m || (cell < 0).any() || cell.x() >= now.cells.cols || cell.y() >= now.cells.rows)
      continue;
    now.cells.at<unsigned char>(static_cast<int>(cell.y()), static_cast<int>(cell.x())) = mapping::FloorPlan::kOccupied;
  }
  return now;
}

}  // namespace

Delivery::Delivery(const Mission& mission, RobotInterface& robot, ReactiveNavigator& navigator)
    : mission_(mission), robot_(robot), navigator_(navigator), spot_(mission.spot) {}

std::string Delivery::phase() const {
  switch (phase_) {
    case Phase::Planning:
      return "planning";
    case Phase::Turning:
      return "turning";
    case Phase::Driving:
      return "driving";
    case Phase::Waiting:
      return "waiting";
    case Phase::Facing:
      return "facing " + mission_.name;
    case Phase::Arrived:
      return "there";
  }
  return "";
}

bool Delivery::isAtSpot() const { return (robot_.T_map_robot().translation() - spot_.p_map_m).norm() < kIsThere_m; }

/// True when turned.
bool Delivery::turnTo(double yaw_rad, double tolerance_rad) {
  const double off_rad = wrapped_rad(yaw_rad - yawOf_rad(robot_.T_map_robot()));
  const bool isTurned = std::abs(off_rad) < tolerance_rad;
  const double speed = std::clamp(kGain_perS * std::abs(off_rad), kSlowestTurn_radps, kFastestTurn_radps);
  robot_.turn(isTurned ? 0.0 : std::copysign(speed, off_rad));
  return isTurned;
}

/// To the spot, or where somebody stands there, to another.
std::optional<std::vector<Eigen::Vector2d>> Delivery::routeOver(const mapping::FloorPlan& plan) {
  const query::DrivableFloor floor(plan, mission_.rules);
  const Eigen::Vector2d here_m = robot_.T_map_robot().translation();
  if (auto route = query::planRoute(floor, here_m, mission_.spot.p_map_m)) {
    spot_ = mission_.spot;
    return route;
  }
  const auto other = floor.spotBeside(*mission_.object, kReach_m, here_m);
  if (!other) return std::nullopt;
  spot_ = *other;
  return query::planRoute(floor, here_m, spot_.p_map_m);
}

/// The first time by the map alone; later around what is seen, and where that leaves no way, it waits.
void Delivery::plan(double now_s) {
  const bool isFirst = plans_++ == 0;
  if (!isFirst) ++replans_;
  const Eigen::Vector2d here_m = robot_.T_map_robot().translation();
  const auto route =
      routeOver(isFirst ? mission_.closedPlan : withSeen(mission_.closedPlan, robot_.scan_map_m(), here_m));
  robot_.halt();
  since_s_ = now_s;
  phase_ = route ? Phase::Turning : Phase::Waiting;
  if (route) route_m_ = *route;
}

void Delivery::turnToRoute(double now_s) {
  const Eigen::Vector2d here_m = robot_.T_map_robot().translation();
  const Eigen::Vector2d ahead = route_m_[std::min<std::size_t>(1, route_m_.size() - 1)] - here_m;
  const double yaw_rad = std::atan2(ahead.y(), ahead.x());
  const bool isAhead = std::abs(wrapped_rad(yaw_rad - yawOf_rad(robot_.T_map_robot()))) < kTurnsFirst_rad;
  const bool wasTurning = now_s - since_s_ > 0.15;
  if (!(isAhead && !wasTurning) && !turnTo(yaw_rad, kTurned_rad)) return;
  navigator_.follow(route_m_, kArrives_m);
  robot_.forgetTrouble();
  headwayAt_s_ = now_s;
  headway_m_ = here_m;
  phase_ = Phase::Driving;
}

bool Delivery::makesNoHeadway(double now_s) {
  const Eigen::Vector2d here_m = robot_.T_map_robot().translation();
  if ((here_m - headway_m_).norm() > kHeadway_m) {
    headwayAt_s_ = now_s;
    headway_m_ = here_m;
  }
  return now_s - headwayAt_s_ > kPatience_s;
}

void Delivery::drive(double now_s) {
  navigator_.step();
  if (navigator_.isDriving() && !robot_.isStuck() && !makesNoHeadway(now_s)) return;
  navigator_.cancel();
  robot_.halt();
  robot_.forgetTrouble();
  phase_ = isAtSpot() ? Phase::Facing : Phase::Planning;
}

void Delivery::face() {
  if (!isAtSpot()) {
    phase_ = Phase::Planning;
  } else if (turnTo(spot_.yaw_rad, kFaces_rad)) {
    robot_.halt();
    phase_ = Phase::Arrived;
  }
}

void Delivery::step(double now_s) {
  if (phase_ == Phase::Waiting) waited_s_ += now_s - last_s_;
  last_s_ = now_s;
  if (phase_ == Phase::Waiting && now_s - since_s_ > kTriesAgain_s) phase_ = Phase::Planning;
  if (phase_ == Phase::Planning) plan(now_s);
  if (phase_ == Phase::Turning) {
    turnToRoute(now_s);
  } else if (phase_ == Phase::Driving) {
    drive(now_s);
  } else if (phase_ == Phase::Facing) {
    face();
  }
}

}  // namespace wardslam::nav_demo
