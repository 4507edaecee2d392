#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "wardslam/core/frame.h"

namespace wardslam::pipeline {

/// Section `map_frame:` of the configuration: what map coordinates refer to.
struct MapFrameOptions {
  std::string start_pose;
  bool level_with_floor = true;
  /// Where the robot's base stands on the floor (or its first base frame) at the first image; for programs that know,
  /// not part of a file. Nothing: above the origin. `start_pose` overrules it.
  std::optional<Eigen::Isometry3d> T_map_base;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("start_pose", self.start_pose,
          "T_map_cam of the first image: x y z qx qy qz qw (m, optical camera frame); empty = from what follows");
    visit("level_with_floor", self.level_with_floor,
          "z = 0 is the floor where the first image shows it; else the map frame is the robot's first base frame");
  }
};

/// Where the camera of the first frame stands in the map frame, whose z axis points up. Throws core::InputError when
/// MapFrameOptions::start_pose is not a pose.
[[nodiscard]] Eigen::Isometry3d startPose(const MapFrameOptions& options, const core::Frame& firstFrame);

/// The same check without a frame, for the time of set-up.
void requireValid(const MapFrameOptions& options);

}  // namespace wardslam::pipeline
