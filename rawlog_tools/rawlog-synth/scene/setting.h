#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "scene/floor_truth.h"
#include "scene/scene.h"

namespace wardslam::synth {

/// What every place is asked.
struct SceneOptions {
  std::uint32_t seed = 1;  ///< Textures, and small differences in how the furniture stands.
  bool people = true;
};

/// A place ready to be recorded. World frame: x and y along the walls, z up, floor at z = 0.
struct Setting {
  Scene scene;
  /// Optical frame of the camera (x right, y down, z forward), `t_s` after the start. Smooth in time.
  std::function<Eigen::Isometry3d(double t_s)> T_world_cam;
  double duration_s = 20.0;  ///< Unless the user asks for another.
  /// The true floor plan of what stands at `until_s`.
  std::function<mapping::FloorPlan(const Scene& scene, double until_s)> floorPlan = trueFloor;
  /// The id of the room around the place, where rooms are known. Empty: they are not.
  std::function<std::string(const Eigen::Vector3d& p_m)> roomAt;
  /// The storey whose height it is, where there are several. Empty: there is one.
  std::function<int(double z_m)> storeyAt;
  /// Writes what else is known of the place into the folder of labels, where there is more. Empty: nothing.
  std::function<void(const std::filesystem::path& labelsFolder, double until_s)> writeFurtherTruth;
};

}  // namespace wardslam::synth
