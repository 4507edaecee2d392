#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "judge.h"
#include "mission.h"
#include "range_scanner.h"
#include "simulated_robot.h"
#include "truth.h"
#include "walker.h"

namespace wardslam::nav_demo {

struct SimulationOptions {
  RobotOptions robot;
  ScannerOptions scanner;
  WalkerHabits people;
  int peopleCount = 3;
  double timeLimit_s = 120.0;
};

/// Where everybody is at a moment; map frame.
struct Moment {
  double t_s = 0.0;
  Eigen::Isometry2d T_map_robot = Eigen::Isometry2d::Identity();  ///< The truth.
  std::vector<Eigen::Vector2d> people_m;
  std::string phase;  ///< What the robot is at.
};

/// One delivery.
struct RunRecord {
  std::uint32_t seed = 0;
  bool arrived = false;
  double time_s = 0.0;
  double waited_s = 0.0;
  int replans = 0;
  Verdict verdict;
  query::Spot spot;              ///< Where it stopped, or was to stop in the end.
  double goalError_m = 0.0;      ///< From there to where it truly stands.
  double facingError_rad = 0.0;  ///< And how far it looks past.
  double toTarget_m = 0.0;       ///< From its hull to the true outline of what it delivers to; NaN where unknown.
  std::vector<Moment> moments;   ///< Ten a second.

  [[nodiscard]] bool isGood() const { return arrived && verdict.isClean(); }
};

/// Drives the mission in the true world among people who walk about. The same seed gives the same run. MRPT's clock
/// shows simulated time meanwhile. `cache`: see ReactiveNavigator. `onMoment` may end the run by returning false.
[[nodiscard]] RunRecord simulate(const Mission& mission, const Truth& truth, const SimulationOptions& options,
                                 std::uint32_t seed, const std::filesystem::path& cache,
                                 const std::function<bool(const Moment&)>& onMoment = {});

}  // namespace wardslam::nav_demo
