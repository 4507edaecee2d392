#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <vector>

#include "wardslam/building/rooms.h"
#include "wardslam/mapping/floor_plan.h"

namespace wardslam::evaluation {

/// Rooms as they were built, and what is between them.
struct TrueBuilding {
  struct Room {
    std::string id;
    std::string name;
    std::vector<Eigen::Vector2d> polygon_m;  ///< Not closed.
  };
  struct Door {
    std::string room;
    std::string other;
    Eigen::Vector2d from_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d to_m = Eigen::Vector2d::Zero();
    bool hasLeaf = true;    ///< Else nothing closes it,
    double open_rad = 0.0;  ///< and with one it is open so far.

    [[nodiscard]] double width_m() const { return (to_m - from_m).norm(); }
    /// How wide one may go through: between the leaf's edge and the frame, or all of it.
    [[nodiscard]] double free_m() const;
  };
  std::vector<Room> rooms;
  std::vector<Door> doors;
};

struct RoomEvaluationOptions {
  double widestDoor_m = 1.8;     ///< Rooms with a wider passage between them are one.
  double leastFree_m = 0.5;      ///< A door less open is none.
  double leastSeen_m2 = 2.0;     ///< A room of which less floor was seen does not count.
  double leastOverlap = 0.5;     ///< Intersection over union of rooms that are the same.
  double mostDoorError_m = 1.0;  ///< From the middle of a door to that of the true one.
};

/// How well rooms and doors were found. Only floor that the map knows counts, free or in a room.
struct RoomEvaluation {
  struct Room {
    std::string name;      ///< Names, where several are open to each other.
    double seen_m2 = 0.0;  ///< Of its floor.
    std::string found;     ///< The room that has most in common with it; empty: none has anything.
    double overlap = 0.0;  ///< With that, intersection over union.
    bool isFound = false;
  };
  std::vector<Room> rooms;  ///< Those of which enough was seen.
  std::size_t told = 0;     ///< Rooms that the map has,
  std::size_t found = 0;    ///< of which so many are true ones.
  std::size_t splits = 0;   ///< Rooms too many where a true room is several,
  std::size_t joins = 0;    ///< and too few where several are one.
  std::size_t doors = 0;    ///< That are open, between rooms that were seen.
  std::size_t doorsTold = 0;
  std::size_t doorsFound = 0;  ///< Of those told, one for one.

  [[nodiscard]] double meanOverlap() const;  ///< Of the rooms found; NaN when there is none.
};

/// `T_truth_map` takes places of the map into the frame of the truth. `plan` and `found` are of one raster.
[[nodiscard]] RoomEvaluation evaluateRooms(const TrueBuilding& truth, const mapping::FloorPlan& plan,
                                           const building::Rooms& found, const Eigen::Isometry2d& T_truth_map,
                                           const RoomEvaluationOptions& options = {});

}  // namespace wardslam::evaluation
