#pragma once

#include <vector>

#include "wardslam/building/rooms.h"
#include "wardslam/mapping/semantic_map.h"

namespace wardslam::building {

struct RoomOptions {
  double widestDoor_m = 1.8;  ///< A wider passage is no door: what it joins is one room.
  double smallestRoom_m2 = 2.0;
};

/// The rooms of a floor plan, found where walls leave but a narrow passage.
///
/// Things of the map, and other islands up to 2.5 m across, are no walls: what they stand on belongs to the room. Each
/// place on the floor has its distance to the nearest wall; a room is the floor around a place where that is largest,
/// and two of them are one unless every way from one to the other gets narrower than the widest door, and than three
/// quarters of the narrower one (the survey of Bormann et al., Room Segmentation, ICRA 2016, has the distance transform
/// and its kin; the merging here is by the persistence of its maxima). A room that no zone is most of has a number for
/// a name.
[[nodiscard]] Rooms findRooms(const mapping::FloorPlan& plan, const std::vector<const mapping::MapObject*>& things,
                              const std::vector<mapping::Zone>& zones, const RoomOptions& options = {});

/// Those of a map. What is gone from it is no wall either.
[[nodiscard]] Rooms findRooms(const mapping::SemanticMap& map, const RoomOptions& options = {});

}  // namespace wardslam::building
