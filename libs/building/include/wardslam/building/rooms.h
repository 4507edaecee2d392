#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "wardslam/mapping/floor_plan.h"

namespace wardslam::building {

/// Floor with walls around it.
struct Room {
  int id = 0;        ///< From 1, in the order of places, row by row; another map of the building may count otherwise.
  std::string name;  ///< Of the zone that is this room; "room 7" where there is none.
  double area_m2 = 0.0;                                ///< What stands on it included, as far as it was seen.
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();  ///< The place farthest from walls, map frame.
  std::vector<Eigen::Vector2d> outline_m;  ///< Around it, not closed, map frame; what may stand in it is not cut out.
};

/// Where one room goes over into another.
struct Door {
  int room = 0;  ///< The smaller id of both.
  int other = 0;
  Eigen::Vector2d from_m = Eigen::Vector2d::Zero();  ///< The shortest line across it, map frame.
  Eigen::Vector2d to_m = Eigen::Vector2d::Zero();
  double width_m = 0.0;  ///< Of the passage: twice the way from the middle to the nearest wall.

  [[nodiscard]] Eigen::Vector2d middle_m() const { return (from_m + to_m) / 2.0; }
};

/// The rooms of a storey. Plain data; findRooms() makes it.
struct Rooms {
  std::vector<Room> all;  ///< Room i has the id i + 1.
  std::vector<Door> doors;
  cv::Mat ids;  ///< CV_32SC1, raster of the floor plan: the room of each cell, 0 = none.
  double resolution_m = 0.05;
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();  ///< Map coordinates of the outer corner of cell (0, 0).

  /// The room around a place, or at most `reach_m` from it (a thing at a wall, a camera over a bed); nullptr where
  /// there is none.
  [[nodiscard]] const Room* at(const Eigen::Vector2d& p_map_m, double reach_m = 0.0) const;
  /// Throws core::InputError, naming the one most like it, where no room is called so.
  [[nodiscard]] const Room& named(const std::string& name) const;
};

}  // namespace wardslam::building
