#pragma once

namespace wardslam::odometry {

struct MatcherOptions {
  double max_descriptor_distance = 80;
  double max_ratio = 0.9;
  double max_semantic_difference = 1.0;
  double wide_radius_px = 15;
  double narrow_radius_px = 4;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("max_descriptor_distance", self.max_descriptor_distance, {1.0, 256.0}, "bit",
          "of 256 between ORB descriptors");
    visit("max_ratio", self.max_ratio, {0.1, 1.0}, "", "best distance over second best, for a match to be clear");
    visit("max_semantic_difference", self.max_semantic_difference, {0.0, 1.0}, "",
          "share of the cells around a key point (n x n of the filter) whose class may differ in a match; 0.25 is the "
          "paper's 110 of 441, 1 = not asked");
    visit("wide_radius_px", self.wide_radius_px, {1.0, 200.0}, "px", "search around the place predicted by motion");
    visit("narrow_radius_px", self.narrow_radius_px, {1.0, 100.0}, "px", "search once the pose is roughly known");
  }
};

struct PoseSolverOptions {
  double pixel_sigma_px = 1.0;
  double depth_sigma_scale = 1.0;
  int max_iterations = 10;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("pixel_sigma_px", self.pixel_sigma_px, {0.1, 10.0}, "px", "noise of a key point on the finest level");
    visit("depth_sigma_scale", self.depth_sigma_scale, {0.1, 100.0}, "", "times the Kinect's depth noise");
    visit("max_iterations", self.max_iterations, {1, 100}, "count", "of the least-squares solver, per round");
  }
};

struct LocalMapOptions {
  int max_points = 20000;
  double max_depth_m = 6.0;
  double min_found_ratio = 0.25;
  int max_fused = 30;
  int max_neighbours = 30;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("max_points", self.max_points, {500, 1000000}, "count", "points kept; those unseen for longest go first");
    visit("max_depth_m", self.max_depth_m, {0.5, 50.0}, "m", "farther key points make no map points");
    visit("max_fused", self.max_fused, {1, 100000}, "count", "measurements of a point that refine its position");
    visit("max_neighbours", self.max_neighbours, {1, 1000}, "count",
          "keyframes whose points are looked for, those that share most with the image");
    visit("min_found_ratio", self.min_found_ratio, {0.0, 1.0}, "", "points found more rarely than this are dropped");
  }
};

struct KeyframeOptions {
  double min_tracked_fraction = 0.75;
  int max_frame_gap = 30;
  int min_new_points = 70;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("min_tracked_fraction", self.min_tracked_fraction, {0.1, 1.0}, "",
          "of the last keyframe's points; a new keyframe comes below it");
    visit("max_frame_gap", self.max_frame_gap, {1, 1000}, "frames", "at most between keyframes");
    visit("min_new_points", self.min_new_points, {1, 10000}, "count", "a keyframe must add");
  }
};

struct RelocalisationOptions {
  double min_found_fraction = 0.15;
  double max_contradiction = 0.25;
  double max_rival = 0.5;
  double max_speed_mps = 2.0;
  double margin_m = 0.5;
  double max_way_m = 4.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("min_found_fraction", self.min_found_fraction, {0.0, 1.0}, "",
          "of the points that should be in sight, or of the key points where these are fewer; a thing that looks like "
          "another shows less");
    visit("max_contradiction", self.max_contradiction, {0.0, 1.0}, "",
          "share of the points that should be in sight whose place is seen to be empty");
    visit("max_rival", self.max_rival, {0.0, 1.0}, "",
          "of the points found, what may say that the camera is somewhere else");
    visit("max_speed_mps", self.max_speed_mps, {0.01, 100.0}, "m/s", "that the camera can have gone with since");
    visit("margin_m", self.margin_m, {0.0, 100.0}, "m", "besides: tracking had drifted when it was lost");
    visit("max_way_m", self.max_way_m, {0.0, 1000.0}, "m",
          "however long it is: farther off, another room may look the same, and the map asks for more");
  }
};

struct RollingShutterOptions {
  bool learn = true;
  double readout_s = 0.0;
  double readout_sigma_s = 0.015;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("learn", self.learn, "from turns of the camera how long it takes to read an image, row by row");
    visit("readout", self.readout_s, {-0.05, 0.05}, "s",
          "from the first row to the last, as far as known before; 0 = all at once, negative = from below");
    visit("readout_sigma", self.readout_sigma_s, {1e-6, 1.0}, "s", "standard deviation of that knowledge");
  }
};

struct DepthAlignmentOptions {
  int below_inliers = 60;
  double anchor_distance_m = 0.25;
  double anchor_angle_rad = 0.25;
  double min_overlap = 0.25;
  double min_agreement = 0.5;
  double max_sigma_m = 0.3;
  double max_start_sigma_m = 0.15;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(
        "below_inliers", self.below_inliers, {0, 100000}, "count",
        "matched points: with fewer, the surfaces of depth images lead the search for points, and hold the pose alone "
        "where there are too few; with more they are one more measurement");
    visit("anchor_distance", self.anchor_distance_m, {0.01, 5.0}, "m", "between images that others are aligned to");
    visit("anchor_angle", self.anchor_angle_rad, {0.01, 3.0}, "rad", "likewise");
    visit("min_overlap", self.min_overlap, {0.0, 1.0}, "",
          "of the surfaces that an image shows, what that image shows, too");
    visit("min_agreement", self.min_agreement, {0.0, 1.0}, "",
          "of the surfaces whose place it shows, what must be there: people who move are not");
    visit("max_sigma", self.max_sigma_m, {0.001, 10.0}, "m",
          "standard deviation of a pose; less sure is lost (along a bare corridor the last speed leads, not for long)");
    visit("max_start_sigma", self.max_start_sigma_m, {0.001, 10.0}, "m",
          "and of the prediction that surfaces alone begin with: after a gap others lie where these would");
  }
};

/// YAML section `odometry:`.
struct OdometryOptions {
  int min_initial_points = 80;
  int min_inliers = 20;
  int max_lost_frames = 15;
  MatcherOptions matcher;
  PoseSolverOptions pose_solver;
  LocalMapOptions local_map;
  KeyframeOptions keyframes;
  RelocalisationOptions relocalisation;
  DepthAlignmentOptions depth_alignment;
  RollingShutterOptions rolling_shutter;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("min_initial_points", self.min_initial_points, {10, 10000}, "count", "key points with depth, to start");
    visit("min_inliers", self.min_inliers, {6, 1000}, "count", "matched points a pose must rest on");
    visit("max_lost_frames", self.max_lost_frames, {0, 100000}, "frames",
          "to look for the known map before a new submap is begun");
    visit.group("matcher", self.matcher);
    visit.group("pose_solver", self.pose_solver);
    visit.group("local_map", self.local_map);
    visit.group("keyframes", self.keyframes);
    visit.group("relocalisation", self.relocalisation);
    visit.group("depth_alignment", self.depth_alignment);
    visit.group("rolling_shutter", self.rolling_shutter);
  }
};

}  // namespace wardslam::odometry
