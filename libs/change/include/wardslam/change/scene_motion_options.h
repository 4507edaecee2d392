#pragma once

namespace wardslam::change {

struct PointTrackerOptions {
  int points = 500;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("points", self.points, {50, 5000}, "count", "points followed from image to image, at most");
  }
};

struct CameraMotionOptions {
  int min_points = 15;
  double min_spread = 0.12;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("min_points", self.min_points, {6, 1000}, "count", "static points a camera motion must rest on");
    visit("min_spread", self.min_spread, {0.0, 1.0}, "",
          "share of the image (in 8 x 6 cells) they must be spread over");
  }
};

struct SceneMotionOptions {
  PointTrackerOptions tracker;
  CameraMotionOptions camera;
  double window_s = 0.5;
  double memory_s = 0.7;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    PointTrackerOptions::describe(self.tracker, visit);
    CameraMotionOptions::describe(self.camera, visit);
    visit("window", self.window_s, {0.1, 2.0}, "s", "how far back images are compared; slow things need longer");
    visit("memory", self.memory_s, {0.05, 10.0}, "s", "after this time without new evidence a third of it is left");
  }
};

}  // namespace wardslam::change
