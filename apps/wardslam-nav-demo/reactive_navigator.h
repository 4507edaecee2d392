#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <vector>

#include "robot_interface.h"

namespace wardslam::nav_demo {

/// MRPT's CReactiveNavigationSystem, set up for this robot.
class ReactiveNavigator {
 public:
  /// `cache`: a folder for the tables it computes once.
  ReactiveNavigator(RobotInterface& robot, const RobotOptions& options, const std::filesystem::path& cache);
  ~ReactiveNavigator();
  ReactiveNavigator(const ReactiveNavigator&) = delete;
  ReactiveNavigator& operator=(const ReactiveNavigator&) = delete;

  /// Drives along these points (map frame) and stops at the last, at most `arrives_m` from it.
  void follow(const std::vector<Eigen::Vector2d>& route_m, double arrives_m);
  void step();
  void cancel();
  [[nodiscard]] bool isDriving() const;

 private:
  struct System;
  std::unique_ptr<System> system_;
};

}  // namespace wardslam::nav_demo
