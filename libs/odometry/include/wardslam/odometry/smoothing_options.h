#pragma once

namespace wardslam::odometry {

/// How poses of a finished run are made one way (trajectory_smoother.h).
struct SmoothingOptions {
  double velocity_change_mps = 1.0;
  double turn_change_radps = 3.0;
  double least_sigma_m = 0.003;
  double longest_bridge_s = 1.5;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("velocity_change_mps", self.velocity_change_mps, {0.0, 100.0}, "m/s",
          "by which the camera's velocity changes within a second, standard deviation; 0: poses stay as they were "
          "measured one by one");
    visit("turn_change_radps", self.turn_change_radps, {0.01, 100.0}, "rad/s", "the same of how fast it turns");
    visit("least_sigma_m", self.least_sigma_m, {0.0, 1.0}, "m",
          "that the pose of a single image errs by for reasons of which its covariance knows nothing (lens, clock, the "
          "points it was measured from)");
    visit("longest_bridge_s", self.longest_bridge_s, {0.0, 60.0}, "s",
          "images without a pose between two with one are given poses on the way between; 0: they have none");
  }
};

}  // namespace wardslam::odometry
