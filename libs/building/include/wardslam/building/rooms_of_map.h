#pragma once

#include <string>

#include "wardslam/building/room_finder.h"
#include "wardslam/mapping/semantic_map.h"

namespace wardslam::building {

/// A thing at a wall stands in the room before it, and a camera over a bed is in the room of the bed.
constexpr double kRoomReach_m = 0.5;

/// The rooms of the map's floor plan, named after its zones. What is gone from the map is no wall either; what is on
/// another storey does not matter.
[[nodiscard]] Rooms roomsOf(const mapping::SemanticMap& map, const RoomOptions& options = {});

/// The name of the room around a place; empty where there is none.
[[nodiscard]] std::string roomAt(const Rooms& rooms, const Eigen::Vector3d& p_map_m);

}  // namespace wardslam::building
