#pragma once

namespace wardslam::graph {

struct BundleAdjustmentOptions {
  int window = 12;
  int min_shared_points = 15;
  int max_fixed_keyframes = 30;
  int max_iterations = 8;
  double pixel_sigma_px = 1.0;
  double depth_sigma_scale = 1.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("window", self.window, {1, 1000}, "count", "keyframes moved, those that share most points with the newest");
    visit("min_shared_points", self.min_shared_points, {1, 10000}, "count", "for two keyframes to be neighbours");
    visit("max_fixed_keyframes", self.max_fixed_keyframes, {0, 1000}, "count",
          "that see the same points and hold still");
    visit("max_iterations", self.max_iterations, {1, 1000}, "count", "of the solver");
    visit("pixel_sigma_px", self.pixel_sigma_px, {0.1, 10.0}, "px", "noise of a key point on the finest level");
    visit("depth_sigma_scale", self.depth_sigma_scale, {0.1, 100.0}, "", "times the Kinect's depth noise");
  }
};

/// YAML section `graph:`.
struct GraphOptions {
  BundleAdjustmentOptions local;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit.group("local", self.local);
  }
};

}  // namespace wardslam::graph
