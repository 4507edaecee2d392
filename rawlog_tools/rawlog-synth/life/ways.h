#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

/// What a hospital offers to those who live in it. World frame, metres; x to the front of whoever sits or stands.
namespace wardslam::synth {

/// Where one can walk: straight edges between nodes, each clear of walls and of what stands there by
/// kWayClearance_m on both sides. Connected.
struct WayGraph {
  std::vector<Eigen::Vector2d> nodes_m;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
};
constexpr double kWayClearance_m = 0.3;

/// Somebody can sit here.
struct Seat {
  Eigen::Vector2d p_m = Eigen::Vector2d::Zero();  ///< Under the middle of the seat.
  double heading_rad = 0.0;                       ///< Where one who sits looks.
  double seat_m = 0.48;                           ///< Height of the seat.
  std::size_t wayNode = 0;                        ///< Nearest node of the graph.
};

/// Somebody can stand here without being in the way.
struct StandingSpot {
  Eigen::Vector2d p_m = Eigen::Vector2d::Zero();
  double heading_rad = 0.0;
  std::size_t wayNode = 0;
};

/// A thing of the scene that somebody may push or carry away.
struct MovableThing {
  std::size_t thing = 0;  ///< Index into Scene::things.
  core::ClassId classId = 0;
  std::string room;                                                 ///< Id of the room it stands in.
  Eigen::Isometry3d T_world_thing = Eigen::Isometry3d::Identity();  ///< Of the model's own frame (furniture.h).
  Eigen::AlignedBox2d footprint_m;                                  ///< In the thing's own frame.
};

/// Everything of a hospital that whoever lives in it needs to know.
struct Ways {
  WayGraph graph;
  std::vector<Seat> seats;
  std::vector<StandingSpot> spots;
  std::vector<MovableThing> movable;
  /// Where the camera is, so that people keep off it or come close by. Any time >= 0.
  std::function<Eigen::Vector2d(double t_s)> camera_m;
};

}  // namespace wardslam::synth
