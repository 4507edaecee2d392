#pragma once

#include <algorithm>
#include <cmath>

#include "furniture/furniture.h"
#include "furniture/scene_builder.h"
#include "life/ways.h"
#include "scene/scene.h"

namespace wardslam::synth::test {

constexpr double kCorridor_m = 40.0;
constexpr double kCorridorWidth_m = 3.0;
constexpr double kRoomDepth_m = 5.0;

/// A corridor along x with four rooms of 10 m × 5 m to its north, and what stands there.
struct LifePlace {
  Scene scene;
  Ways ways;
};

inline void addWall(Surfaces& walls, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const auto p = a.cast<float>();
  const auto along = (b - a).cast<float>();
  walls.push_back({Material::WallNorth, panel({p.x(), p.y(), 0}, {along.x(), along.y(), 0}, {0, 0, 2.8F})});
}

/// There and back along the corridor at 0.5 m/s, looking into the second room on the way.
inline Eigen::Vector2d drivenPlace(double t_s) {
  const std::vector<Eigen::Vector2d> corners = {{1.5, 1.5},  {15.0, 1.5}, {15.0, 5.0}, {15.5, 5.0}, {15.5, 1.5},
                                                {38.0, 1.5}, {38.0, 1.3}, {1.5, 1.3},  {1.5, 1.5}};
  double length_m = 0.0;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) length_m += (corners[i + 1] - corners[i]).norm();
  double left_m = std::fmod(0.5 * t_s, length_m);
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const double leg_m = (corners[i + 1] - corners[i]).norm();
    if (left_m <= leg_m) return corners[i] + left_m / leg_m * (corners[i + 1] - corners[i]);
    left_m -= leg_m;
  }
  return corners.back();
}

inline std::size_t addNode(WayGraph& graph, double x, double y) {
  graph.nodes_m.emplace_back(x, y);
  return graph.nodes_m.size() - 1;
}

inline void addRoom(LifePlace& place, Surfaces& walls, int number, std::size_t atDoor) {
  const double x = 10.0 * number;
  const double north = kCorridorWidth_m + kRoomDepth_m;
  addWall(walls, {x, kCorridorWidth_m}, {x + 4.2, kCorridorWidth_m});
  addWall(walls, {x + 5.8, kCorridorWidth_m}, {x + 10, kCorridorWidth_m});
  addWall(walls, {x + 10, kCorridorWidth_m}, {x + 10, north});
  WayGraph& graph = place.ways.graph;
  const std::size_t door = addNode(graph, x + 5, kCorridorWidth_m);
  const std::size_t middle = addNode(graph, x + 5, 5.0);
  const std::size_t west = addNode(graph, x + 2, 5.0);
  const std::size_t east = addNode(graph, x + 8, 5.0);
  graph.edges.insert(graph.edges.end(), {{atDoor, door}, {door, middle}, {middle, west}, {middle, east}});
  place.ways.seats.push_back({{x + 1.5, 7.5}, -M_PI / 2, 0.495, west});
  place.ways.seats.push_back({{x + 8.5, 7.5}, -M_PI / 2, 0.495, east});
  place.ways.spots.push_back({{x + 3.0, 7.0}, 0.3, west});
  place.ways.spots.push_back({{x + 7.0, 7.2}, 2.0, east});
}

inline void addMovable(LifePlace& place, std::uint16_t id, core::ClassId classId, const std::string& kind,
                       const Surfaces& model, const Eigen::Isometry3f& T, const Eigen::AlignedBox2d& footprint) {
  place.ways.movable.push_back({place.scene.things.size(), classId, "corridor", T.cast<double>(), footprint});
  place.scene.things.push_back({{id, kind + "_1", classId, kind}, placed(model, T)});
}

inline LifePlace lifePlace() {
  LifePlace place;
  Surfaces walls;
  const double north = kCorridorWidth_m + kRoomDepth_m;
  addWall(walls, {0, 0}, {kCorridor_m, 0});
  addWall(walls, {0, 0}, {0, north});
  addWall(walls, {0, north}, {kCorridor_m, north});
  addWall(walls, {kCorridor_m, 0}, {kCorridor_m, kCorridorWidth_m});
  WayGraph& graph = place.ways.graph;
  std::size_t before = addNode(graph, 1.0, 1.5);
  for (int i = 0; i < 4; ++i) {
    const std::size_t atDoor = addNode(graph, 10.0 * i + 5, 1.5);
    graph.edges.emplace_back(before, atDoor);
    addRoom(place, walls, i, atDoor);
    before = atDoor;
  }
  graph.edges.emplace_back(before, addNode(graph, 39.0, 1.5));
  Thing building;
  building.label = {0, "room", 0, ""};
  building.surfaces = walls;
  place.scene.things.push_back(building);
  cv::RNG rng(7);
  addMovable(place, 1, kTrolley, "trolley", makeTrolley(rng), at(22.5F, 0.45F, 0, 0),
             {Eigen::Vector2d(-0.52, -0.25), Eigen::Vector2d(0.4, 0.25)});
  addMovable(place, 2, kChair, "chair", makeChair(rng), at(32.0F, 0.4F, 0, 1.57079633F),
             {Eigen::Vector2d(-0.25, -0.25), Eigen::Vector2d(0.23, 0.25)});
  place.ways.camera_m = drivenPlace;
  return place;
}

}  // namespace wardslam::synth::test
