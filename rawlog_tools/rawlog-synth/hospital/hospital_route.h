#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "camera/camera_mount.h"
#include "camera/closed_route.h"
#include "hospital/hospital_plan.h"

namespace wardslam::synth {

enum class RouteKind {
  Tour,      ///< 500 m and more: laps and figures of eight through corridors, wards, lobby and day room.
  Wards,     ///< One lap that calls at every open ward.
  Round,     ///< One lap of both corridors.
  Corridor,  ///< The long corridor up and down.
  Lobby      ///< Around the lobby.
};

/// Which route, and which robot drives it: another one begins elsewhere, in another order, the odd ones the other way.
struct RouteChoice {
  RouteKind kind = RouteKind::Tour;
  int robot = 0;
};

/// A robot's round. It slows down in bends, and begins again at the end.
class HospitalRoute {
 public:
  HospitalRoute(const HospitalPlan& plan, const RouteChoice& choice, std::uint32_t seed);

  [[nodiscard]] double length_m() const { return route_.length_m(); }
  [[nodiscard]] double round_s() const { return static_cast<double>(at_m_.size() - 1) * kStep_s; }
  /// Way and heading at that time, any time >= 0.
  [[nodiscard]] ClosedRoute::Place at(double t_s) const;
  /// The optical frame (x right, y down, z forward) of the robot's camera.
  [[nodiscard]] Eigen::Isometry3d T_world_cam(double t_s, const CameraMount& mount = {}) const;

  static constexpr double kSpeed_mps = 0.9;
  static constexpr double kTurning_rps = 0.7;  ///< It turns no faster.

 private:
  static constexpr double kStep_s = 0.05;
  ClosedRoute route_;
  std::vector<double> at_m_;  ///< How far it is every kStep_s.
};

}  // namespace wardslam::synth
