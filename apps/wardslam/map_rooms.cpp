#include "map_rooms.h"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "answer.h"
#include "picture_file.h"
#include "support/table.h"
#include "wardslam/building/rooms_of_map.h"
#include "wardslam/building/storeys.h"
#include "wardslam/viewer/rooms_picture.h"

namespace wardslam::apps {
namespace {

using Json = nlohmann::ordered_json;

/// Numbers, by the name of the room.
struct Contents {
  std::map<std::string, std::vector<std::uint64_t>> things;  ///< That stand there now.
  std::map<std::string, std::vector<std::uint64_t>> keyframes;
};

/// On other storeys it is over or under the rooms.
Contents contentsOf(const mapping::SemanticMap& map, const building::Rooms& rooms,
                    const std::vector<building::Storey>& storeys) {
  Contents contents;
  for (const auto& [id, object] : map.objects) {
    if (object.piece != map.piece || object.state == mapping::ObjectState::Gone) continue;
    if (!building::isOnPlan(storeys, object.centroid_m.z())) continue;
    contents.things[building::roomAt(rooms, object.centroid_m)].push_back(id);
  }
  for (const auto& [id, keyframe] : map.keyframes) {
    if (keyframe.piece != map.piece || !building::isOnPlan(storeys, keyframe.T_map_cam.translation().z())) continue;
    contents.keyframes[building::roomAt(rooms, keyframe.T_map_cam.translation())].push_back(id);
  }
  return contents;
}

Json toJson(const Eigen::Vector2d& p_m) { return {p_m.x(), p_m.y()}; }

Json toJson(const building::Room& room, Contents& contents) {
  Json outline = Json::array();
  for (const auto& corner : room.outline_m) outline.push_back(toJson(corner));
  return {{"id", room.id},
          {"name", room.name},
          {"area_m2", room.area_m2},
          {"middle", toJson(room.middle_m)},
          {"objects", contents.things[room.name].size()},
          {"keyframes", contents.keyframes[room.name].size()},
          {"object_ids", contents.things[room.name]},
          {"keyframe_ids", contents.keyframes[room.name]},
          {"outline", outline}};
}

const std::string& nameOf(const building::Rooms& rooms, int id) {
  return rooms.all[static_cast<std::size_t>(id - 1)].name;
}

Json toJson(const std::vector<building::Storey>& storeys) {
  Json list = Json::array();
  for (const auto& storey : storeys) {
    list.push_back({{"floor_m", {storey.lowest_m, storey.highest_m}},
                    {"keyframes", storey.keyframes.size()},
                    {"has_plan", storey.hasPlan}});
  }
  return list;
}

Json toJson(const building::Rooms& rooms, Contents& contents, const std::vector<building::Storey>& storeys) {
  Json list = Json::array();
  for (const auto& room : rooms.all) list.push_back(toJson(room, contents));
  Json doors = Json::array();
  for (const auto& door : rooms.doors) {
    doors.push_back({{"rooms", {nameOf(rooms, door.room), nameOf(rooms, door.other)}},
                     {"from", toJson(door.from_m)},
                     {"to", toJson(door.to_m)},
                     {"width_m", door.width_m}});
  }
  Json answer = {{"rooms", list}, {"doors", doors}};
  if (storeys.size() > 1) answer["storeys"] = toJson(storeys);  // of one alone there is nothing to tell
  return answer;
}

void print(std::ostream& out, const std::vector<building::Storey>& storeys) {
  if (storeys.size() < 2) return;
  for (const auto& storey : storeys) {
    out << (storey.hasPlan ? "storey with these rooms" : "another storey") << ": floor at " << fixed(storey.lowest_m, 2)
        << " m, " << storey.keyframes.size() << " keyframes\n";
  }
}

void print(std::ostream& out, const building::Rooms& rooms, Contents& contents) {
  std::map<int, std::string> leadsTo;
  for (const auto& door : rooms.doors) {
    for (const auto& [room, other] : {std::pair(door.room, door.other), std::pair(door.other, door.room)}) {
      auto& names = leadsTo[room];
      names += (names.empty() ? "" : ", ") + nameOf(rooms, other);
    }
  }
  Table table({"room", "area [m2]", "middle [m]", "objects", "keyframes", "doors to"});
  for (const auto& room : rooms.all) {
    table.add({room.name, fixed(room.area_m2, 1), fixed(room.middle_m.x(), 2) + " " + fixed(room.middle_m.y(), 2),
               std::to_string(contents.things[room.name].size()), std::to_string(contents.keyframes[room.name].size()),
               leadsTo[room.id]});
  }
  table.print(out);
}

}  // namespace

void answerRooms(const MapQuestion& question, const mapping::SemanticMap& map) {
  const auto rooms = building::roomsOf(map, question.rooms);
  if (!question.picture.empty()) writePng(question.picture, viewer::drawRooms(rooms));
  const auto storeys = building::storeysOf(map);
  auto contents = contentsOf(map, rooms, storeys);
  show(question.json, toJson(rooms, contents, storeys), [&](std::ostream& out) {
    print(out, rooms, contents);
    print(out, storeys);
  });
}

void addRoomsOptions(CLI::App& verb, MapQuestion& question) {
  verb.add_option("--picture", question.picture, "write a PNG of them, too");
  verb.add_option("--widest-door", question.rooms.widestDoor_m,
                  "a wider passage joins what it leads to to one room, metres")
      ->check(CLI::Range(0.5, 10.0))
      ->capture_default_str();
}

}  // namespace wardslam::apps
