#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::nav_demo {

/// A thing where it truly stands.
struct TrueThing {
  std::string className;
  Eigen::AlignedBox2d box_m;  ///< Its outline, world frame.
};

/// The world the robot drives in, and how the map lies in it.
struct Truth {
  mapping::FloorPlan floor;  ///< World frame.
  std::vector<TrueThing> things;
  Eigen::Isometry2d T_world_map = Eigen::Isometry2d::Identity();
  double mapError_m = 0.0;  ///< RMS of the keyframes' places.
  std::string source;       ///< For people.
};

/// From what rawlog-synth wrote beside FILE.rawlog: the true floor plan, the objects, and the camera's true way, on
/// which the map's keyframes are laid. Throws core::InputError naming the file that is missing or wrong.
[[nodiscard]] Truth readTruth(const std::filesystem::path& rawlog, const mapping::SemanticMap& map);

/// Where there is none: the world is taken to be as the map says.
[[nodiscard]] Truth truthFromMap(const mapping::SemanticMap& map);

}  // namespace wardslam::nav_demo
