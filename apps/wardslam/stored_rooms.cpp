#include "stored_rooms.h"

#include <string>
#include <vector>

namespace wardslam::apps {

building::Rooms roomsOf(const mapping::SemanticMap& map, const building::RoomOptions& options) {
  std::vector<const mapping::MapObject*> things;
  for (const auto& [id, object] : map.objects) {
    if (object.piece == map.piece) things.push_back(&object);
  }
  return building::findRooms(map.floorPlan, things, map.zones, options);
}

std::string roomAt(const building::Rooms& rooms, const Eigen::Vector3d& p_map_m) {
  const auto* room = rooms.at(p_map_m.head<2>(), kRoomReach_m);
  return room == nullptr ? std::string() : room->name;
}

}  // namespace wardslam::apps
