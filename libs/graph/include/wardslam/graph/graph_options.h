#pragma once

#include <cstdint>

namespace wardslam::graph {

struct BundleAdjustmentOptions {
  int window = 12;
  int min_shared_points = 15;
  int max_fixed_keyframes = 30;
  int local_iterations = 8;
  int global_iterations = 15;
  double pixel_sigma_px = 1.0;
  double depth_sigma_scale = 1.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("window", self.window, {1, 1000}, "count", "keyframes moved, those that share most points with the newest");
    visit("min_shared_points", self.min_shared_points, {1, 10000}, "count", "for two keyframes to be neighbours");
    visit("max_fixed_keyframes", self.max_fixed_keyframes, {0, 1000}, "count",
          "that see the same points and hold still");
    visit("local_iterations", self.local_iterations, {1, 1000}, "count", "of the solver after every keyframe");
    visit("global_iterations", self.global_iterations, {0, 1000}, "count", "of the solver over the map after a loop");
    visit("pixel_sigma_px", self.pixel_sigma_px, {0.1, 10.0}, "px", "noise of a key point on the finest level");
    visit("depth_sigma_scale", self.depth_sigma_scale, {0.1, 100.0}, "", "times the Kinect's depth noise");
  }
};

struct PlaceRecognitionOptions {
  int min_keyframe_gap = 20;
  int max_descriptor_distance = 50;
  int min_votes = 20;
  int max_candidates = 3;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("min_keyframe_gap", self.min_keyframe_gap, {1, 10000}, "count", "keyframes since a place was left");
    visit("max_descriptor_distance", self.max_descriptor_distance, {1, 256}, "bit", "of key points that look alike");
    visit("min_votes", self.min_votes, {1, 10000}, "count", "key points that must look alike");
    visit("max_candidates", self.max_candidates, {1, 100}, "count", "places that are verified, likeliest first");
  }
};

struct LoopVerificationOptions {
  int neighbours = 5;
  int min_recognised = 15;
  double search_radius_px = 8.0;
  int min_inliers = 30;
  double min_found_fraction = 0.12;
  double min_drift_m = 0.3;
  double min_drift_rad = 0.15;
  double position_drift = 0.02;
  double rotation_drift_rad = 0.002;
  double gate_sigmas = 3.5;
  double max_contradiction = 0.2;
  double max_speed_mps = 1.5;
  double lost_margin_m = 1.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("neighbours", self.neighbours, {0, 100}, "count",
          "keyframes around the old place whose points are looked for");
    visit("min_recognised", self.min_recognised, {6, 10000}, "count", "points that agree on a pose by looks alone");
    visit("search_radius_px", self.search_radius_px, {1.0, 100.0}, "px", "around where points of the place should be");
    visit("min_inliers", self.min_inliers, {6, 10000}, "count", "points of the place that must be found");
    visit("min_found_fraction", self.min_found_fraction, {0.0, 1.0}, "",
          "of an old keyframe's points that should be in sight; a thing that looks like another shows less");
    visit("min_drift_m", self.min_drift_m, {0.0, 100.0}, "m", "correction that is always believed");
    visit("min_drift_rad", self.min_drift_rad, {0.0, 3.2}, "rad", "likewise");
    visit("position_drift", self.position_drift, {0.0, 10.0}, "m",
          "one standard deviation after a metre; it grows with the square root of the way");
    visit("rotation_drift_rad", self.rotation_drift_rad, {0.0, 1.0}, "rad", "likewise, about each axis");
    visit("gate_sigmas", self.gate_sigmas, {1.0, 100.0}, "",
          "standard deviations of drift; a loop that asks for more correction is taken for a look-alike");
    visit("max_contradiction", self.max_contradiction, {0.0, 1.0}, "",
          "share of the surfaces of one look whose place the other sees empty; more is another place");
    visit("max_speed_mps", self.max_speed_mps, {0.01, 100.0}, "m/s",
          "that the camera can have gone with where tracking was lost: joins ask for no more");
    visit("lost_margin_m", self.lost_margin_m, {0.0, 100.0}, "m", "besides, each time");
  }
};

struct LoopConfirmationOptions {
  int keyframes = 2;
  int keyframes_to_join = 3;
  int max_gap = 4;
  double max_disagreement_m = 0.15;
  double max_disagreement_rad = 0.05;
  double max_misfit_m = 0.15;
  double max_misfit_rad = 0.05;
  int strong_inliers = 80;
  double strong_spread = 0.5;
  double strong_overlap = 0.5;
  double strong_contradiction = 0.05;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("keyframes", self.keyframes, {1, 1000}, "count", "that must see the same place again, for a loop");
    visit("keyframes_to_join", self.keyframes_to_join, {1, 1000}, "count",
          "likewise, for two pieces of the map to become one, as nothing else says where they lie; a strong look is "
          "enough, and when a run ends, the best there was");
    visit("max_gap", self.max_gap, {1, 1000}, "count", "keyframes from one that sees it to the next");
    visit("max_disagreement_m", self.max_disagreement_m, {0.001, 10.0}, "m", "between what two of them say");
    visit("max_disagreement_rad", self.max_disagreement_rad, {0.001, 3.2}, "rad", "likewise");
    visit("max_misfit_m", self.max_misfit_m, {0.001, 10.0}, "m",
          "of a loop, or of keyframes that see the same, after everything was adjusted; else the loop is taken back");
    visit("max_misfit_rad", self.max_misfit_rad, {0.001, 3.2}, "rad", "likewise");
    visit("strong_inliers", self.strong_inliers, {1, 10000}, "count", "points of the place found in a strong look,");
    visit("strong_spread", self.strong_spread, {0.0, 1.0}, "", "in so much of the image (of 4 x 4 parts),");
    visit("strong_overlap", self.strong_overlap, {0.0, 1.0}, "", "with so much of the depth borne out");
    visit("strong_contradiction", self.strong_contradiction, {0.0, 1.0}, "", "and so little of it contradicted");
  }
};

enum class PoseGraphSolver : std::uint8_t { Ceres, Levmarq };

struct PoseGraphOptions {
  PoseGraphSolver solver = PoseGraphSolver::Ceres;
  int min_shared_points = 60;
  int max_iterations = 50;
  double position_sigma_m = 0.02;
  double rotation_sigma_rad = 0.01;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("solver", self.solver, {"ceres", "levmarq"}, "Ceres with a robust kernel, or MRPT's optimiser as a baseline");
    visit("min_shared_points", self.min_shared_points, {1, 10000}, "count",
          "for keyframes to hold each other in place");
    visit("max_iterations", self.max_iterations, {1, 10000}, "count", "of the solver");
    visit("position_sigma_m", self.position_sigma_m, {1e-4, 10.0}, "m", "of one keyframe seen from another");
    visit("rotation_sigma_rad", self.rotation_sigma_rad, {1e-4, 1.0}, "rad", "of one keyframe seen from another");
  }
};

struct RedundancyOptions {
  int witnesses = 2;
  double min_share = 0.8;
  int min_shared_points = 15;
  int min_keyframe_gap = 20;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("witnesses", self.witnesses, {1, 1000}, "count",
          "older keyframes that show the same, for one to be given up");
    visit("min_share", self.min_share, {0.1, 1.0}, "", "of its points that each of them has in sight from as near");
    visit("min_shared_points", self.min_shared_points, {1, 10000}, "count", "it must share with each of them");
    visit("min_keyframe_gap", self.min_keyframe_gap, {1, 10000}, "count",
          "keyframes by which each of them must be older: it is of an earlier visit");
  }
};

/// YAML section `graph:`.
struct GraphOptions {
  bool close_loops = true;
  bool cull_keyframes = true;
  bool floor = true;
  int probation_keyframes = 3;
  RedundancyOptions redundancy;
  BundleAdjustmentOptions bundle_adjustment;
  PlaceRecognitionOptions place_recognition;
  LoopVerificationOptions loop_verification;
  LoopConfirmationOptions loop_confirmation;
  PoseGraphOptions pose_graph;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("close_loops", self.close_loops, "recognise places, correct the map there, join submaps");
    visit("cull_keyframes", self.cull_keyframes,
          "give up keyframes that show nothing others do not: the map grows with the area, not with time");
    visit("floor", self.floor,
          "keyframes that see the same level floor hold its plane in common: height and level drift less");
    visit("probation_keyframes", self.probation_keyframes, {1, 1000}, "count",
          "in which a new point must be seen again, or it is dropped");
    visit.group("redundancy", self.redundancy);
    visit.group("bundle_adjustment", self.bundle_adjustment);
    visit.group("place_recognition", self.place_recognition);
    visit.group("loop_verification", self.loop_verification);
    visit.group("loop_confirmation", self.loop_confirmation);
    visit.group("pose_graph", self.pose_graph);
  }
};

}  // namespace wardslam::graph
