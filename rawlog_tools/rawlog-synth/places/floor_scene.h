#pragma once

#include <Eigen/Geometry>

#include "camera/camera_mount.h"
#include "camera/closed_route.h"
#include "people/people.h"
#include "scene/setting.h"

/// A floor of a hospital: two rooms beside each other with a door between them, and a corridor along both.
namespace wardslam::synth {

/// With people: a nurse who comes along the corridor, a visitor, a porter.
[[nodiscard]] Scene buildFloor(const SceneOptions& options);

/// How the camera drives: along the corridor, through both rooms, and back to where it began.
struct FloorPath {
  double round_s = 60.0;
  ClosedRoute route = floorRoute();
  CameraMount mount = {};

  [[nodiscard]] Eigen::Isometry3d T_world_cam(double t_s) const;
  [[nodiscard]] static ClosedRoute floorRoute();
};

/// One round of it.
[[nodiscard]] Setting floorSetting(const SceneOptions& options, const CameraMount& mount);

/// Everybody repeats their round with the camera's.
[[nodiscard]] PeopleWays floorWays();

}  // namespace wardslam::synth
