#pragma once

#include <mrpt/kinematics/CVehicleSimul_DiffDriven.h>

#include <Eigen/Geometry>
#include <random>
#include <vector>

namespace wardslam::nav_demo {

struct RobotOptions {
  double radius_m = 0.25;
  double margin_m = 0.07;  ///< Ways are planned for a robot so much wider.
  double maxSpeed_mps = 0.6;
  double maxTurn_radps = 1.2;
  double braking_mps2 = 0.6;
  double keepsOff_m = 0.05;      ///< It stops so far from what the scanner sees in its way.
  double carefulWithin_m = 0.5;  ///< It slows down the nearer anything is, from this far on,
  double slowestShare = 0.3;     ///< to this share of its speed.
  double lag_s = 0.15;           ///< Time constant of the wheels.
  double scanPeriod_s = 0.1;
  double fixSigma_m = 0.01;  ///< Localisation: noise of every fix, on top of the map's own error.
  double fixSigma_rad = 0.005;
};

/// A round robot with two wheels in the true world (MRPT's CVehicleSimul_DiffDriven). It slows down by itself for what
/// its scanner sees in its way, as a safety scanner makes robots do.
class SimulatedRobot {
 public:
  SimulatedRobot(const RobotOptions& options, const Eigen::Isometry2d& T_world_robot, std::uint32_t seed);

  /// Robot frame; what it sees from now on.
  void see(std::vector<Eigen::Vector2d> scan_m) { scan_m_ = std::move(scan_m); }
  void drive(double forward_mps, double turn_radps);
  void step(double dt_s) { vehicle_.simulateOneTimeStep(dt_s); }

  [[nodiscard]] Eigen::Isometry2d T_world_robot() const;
  /// Where it believes to be: the truth and noise.
  [[nodiscard]] Eigen::Isometry2d fix();
  [[nodiscard]] double forward_mps() const { return vehicle_.getCurrentGTVelLocal().vx; }
  [[nodiscard]] double turn_radps() const { return vehicle_.getCurrentGTVelLocal().omega; }
  [[nodiscard]] const RobotOptions& options() const { return options_; }

 private:
  [[nodiscard]] double carefulShare() const;
  [[nodiscard]] double safeShare(double forward_mps, double turn_radps) const;

  RobotOptions options_;
  mrpt::kinematics::CVehicleSimul_DiffDriven vehicle_;
  std::vector<Eigen::Vector2d> scan_m_;
  std::mt19937 random_;
};

}  // namespace wardslam::nav_demo
