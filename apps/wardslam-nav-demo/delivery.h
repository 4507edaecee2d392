#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "mission.h"
#include "reactive_navigator.h"
#include "robot_interface.h"

namespace wardslam::nav_demo {

/// Drives to the mission's spot: turns towards the way, follows it with the reactive navigator, plans anew around
/// whoever blocks it, waits where there is no way around, and turns to face the object in the end.
class Delivery {
 public:
  Delivery(const Mission& mission, RobotInterface& robot, ReactiveNavigator& navigator);

  /// Ten times a second, after RobotInterface::update().
  void step(double now_s);

  [[nodiscard]] bool isOver() const { return phase_ == Phase::Arrived; }
  /// Where it stops: the mission's spot, or another beside the object when somebody stands there.
  [[nodiscard]] const query::Spot& spot() const { return spot_; }
  [[nodiscard]] int replans() const { return replans_; }
  [[nodiscard]] double waited_s() const { return waited_s_; }
  /// What it is at, for people.
  [[nodiscard]] std::string phase() const;

 private:
  enum class Phase { Planning, Turning, Driving, Waiting, Facing, Arrived };

  void plan(double now_s);
  [[nodiscard]] std::optional<std::vector<Eigen::Vector2d>> routeOver(const mapping::FloorPlan& plan);
  void turnToRoute(double now_s);
  void drive(double now_s);
  void face();
  [[nodiscard]] bool turnTo(double yaw_rad, double tolerance_rad);
  [[nodiscard]] bool isAtSpot() const;
  [[nodiscard]] bool makesNoHeadway(double now_s);

  const Mission& mission_;
  RobotInterface& robot_;
  ReactiveNavigator& navigator_;
  Phase phase_ = Phase::Planning;
  query::Spot spot_;
  std::vector<Eigen::Vector2d> route_m_;
  double since_s_ = 0.0;  ///< When the phase began.
  double last_s_ = 0.0;
  double headwayAt_s_ = 0.0;
  Eigen::Vector2d headway_m_ = Eigen::Vector2d::Zero();
  int plans_ = 0;
  int replans_ = 0;
  double waited_s_ = 0.0;
};

}  // namespace wardslam::nav_demo
