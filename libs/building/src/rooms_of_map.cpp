#include "wardslam/building/rooms_of_map.h"

#include <string>
#include <vector>

#include "wardslam/building/storeys.h"

namespace wardslam::building {

Rooms roomsOf(const mapping::SemanticMap& map, const RoomOptions& options) {
  std::vector<const mapping::MapObject*> things;
  const auto storeys = storeysOf(map);
  for (const auto& [id, object] : map.objects) {
    if (object.piece == map.piece && isOnPlan(storeys, object.centroid_m.z())) things.push_back(&object);
  }
  return findRooms(map.floorPlan, things, map.zones, options);
}

std::string roomAt(const Rooms& rooms, const Eigen::Vector3d& p_map_m) {
  const auto* room = rooms.at(p_map_m.head<2>(), kRoomReach_m);
  return room == nullptr ? std::string() : room->name;
}

}  // namespace wardslam::building
