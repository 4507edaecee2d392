#pragma once

#include "wardslam/core/options.h"
#include "wardslam/mapping/floor_planner.h"

namespace wardslam::mapping {

/// Which frames are worked into the map besides keyframes.
struct ViewOptions {
  double step_m = 0.1;
  double turn_rad = 0.06;
  double gap_s = 0.5;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("step_m", self.step_m, {0.0, 10.0}, "m", "the camera moves at most so far between two frames of the map");
    visit("turn_rad", self.turn_rad, {0.0, 3.2}, "rad", "and turns at most so far");
    visit("gap_s", self.gap_s, {0.0, 60.0}, "s", "and at most so much time passes");
  }
};

struct CloudOptions {
  double voxel_m = 0.025;
  double max_range_m = 6.0;
  double max_sigma_m = 0.035;
  int pixel_step = 2;
  int mover_margin_px = 8;
  int min_sightings = 2;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("voxel_m", self.voxel_m, {0.005, 0.5}, "m", "side of the cells that hold one point each");
    visit("max_range_m", self.max_range_m, {0.5, 50.0}, "m", "depth beyond is not used");
    visit("max_sigma_m", self.max_sigma_m, {0.001, 1.0}, "m",
          "points never seen with less depth noise than this (0.035: from nearer than 4.6 m) serve objects only");
    visit("pixel_step", self.pixel_step, {1, 16}, "px", "every so many pixels of a row and of a column are used");
    visit("mover_margin_px", self.mover_margin_px, {0, 100}, "px", "what moves is taken to be this much wider");
    visit("min_sightings", self.min_sightings, {1, 100}, "count", "frames that must have seen a point");
  }
};

struct ObjectOptions {
  double cluster_gap_m = 0.08;
  double min_overlap = 0.3;
  double min_overlap_across_classes = 0.5;
  int min_points = 8;
  double min_evidence = 2.0;
  double min_seen_fraction = 0.2;
  double push_speed_mps = 1.5;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("cluster_gap_m", self.cluster_gap_m, {0.01, 1.0}, "m", "parts of a thing in one image lie no farther apart");
    visit("min_overlap", self.min_overlap, {0.01, 1.0}, "",
          "of the points in sight, that a detection shares with an object of its class to show it again");
    visit("min_overlap_across_classes", self.min_overlap_across_classes, {0.01, 1.0}, "",
          "the same where the class differs");
    visit("min_points", self.min_points, {1, 10000}, "count", "points an object must have");
    visit("min_evidence", self.min_evidence, {0.0, 1000.0}, "",
          "sum of the confidences of the detections that must have shown an object, of two frames at least");
    visit("min_seen_fraction", self.min_seen_fraction, {0.0, 1.0}, "",
          "of the frames that had an object in plain sight, those that must have seen it");
    visit("push_speed_mps", self.push_speed_mps, {0.0, 10.0}, "m/s",
          "a thing that somebody moved is not looked for farther off than it comes at this speed (1.5: a brisk walk)");
  }
};

/// YAML section `mapping:`.
struct MappingOptions {
  bool enabled = true;
  ViewOptions views;
  CloudOptions cloud;
  ObjectOptions objects;
  FloorPlanOptions floor_plan;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("enabled", self.enabled, "build the semantic map: coloured cloud and objects");
    visit.group("views", self.views);
    visit.group("cloud", self.cloud);
    visit.group("objects", self.objects);
    visit.group("floor_plan", self.floor_plan);
  }
};

}  // namespace wardslam::mapping
