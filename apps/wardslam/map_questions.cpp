#include "map_questions.h"

#include <algorithm>
#include <set>

#include "answer.h"
#include "map_report.h"
#include "support/table.h"
#include "wardslam/building/rooms_of_map.h"
#include "wardslam/building/storeys.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/nearest_name.h"
#include "wardslam/query/map_query.h"

namespace wardslam::apps {
namespace {

core::ClassId classNamed(const std::string& name, const core::LabelSpace& labels) {
  if (const auto found = labels.find(name)) return *found;
  std::vector<std::string> names;
  for (int id = 0; id <= UINT8_MAX; ++id) {
    if (!labels.name(static_cast<core::ClassId>(id)).empty())
      names.push_back(labels.name(static_cast<core::ClassId>(id)));
  }
  throw core::InputError("no class is called '" + name + "'; did you mean '" + core::nearestName(name, names) + "'?");
}

std::string zoneNamed(const std::string& name, const mapping::SemanticMap& map) {
  std::vector<std::string> names;
  for (const auto& zone : map.zones) names.push_back(zone.name);
  if (std::find(names.begin(), names.end(), name) != names.end()) return name;
  if (names.empty()) throw core::InputError("the map has no zones, so none called '" + name + "'");
  throw core::InputError("no zone is called '" + name + "'; did you mean '" + core::nearestName(name, names) + "'?");
}

std::set<mapping::ObjectState> statesNamed(const std::string& name) {
  using mapping::ObjectState;
  if (name == "static") return {ObjectState::Static};
  if (name == "moved") return {ObjectState::Moved};
  if (name == "gone") return {ObjectState::Gone};
  if (name == "any") return {ObjectState::Static, ObjectState::Moved, ObjectState::Gone};
  return query::ObjectFilter().states;
}

query::ObjectFilter filterOf(const MapQuestion& question, const mapping::SemanticMap& map) {
  query::ObjectFilter filter;
  if (!question.className.empty()) filter.classId = classNamed(question.className, map.labels);
  if (!question.zone.empty()) filter.zone = zoneNamed(question.zone, map);
  if (!question.box_m.empty()) {
    const Eigen::Vector3d first(question.box_m.data());
    const Eigen::Vector3d second(question.box_m.data() + 3);
    filter.box_m.emplace(first.cwiseMin(second), first.cwiseMax(second));
  }
  filter.unseenAtLeast_s = question.unseenFor_s;
  filter.unseenAtMost_s = question.seenWithin_s;
  filter.states = statesNamed(question.state);
  filter.onlyFree = question.free;
  return filter;
}

std::optional<query::NearObject> findNearest(const MapQuestion& question, const query::MapQuery& query,
                                             const query::ObjectFilter& filter) {
  const Eigen::Vector2d floor_m(question.point_m.data());
  if (question.alongFloor) return query.nearestAlongFloor(floor_m, filter);
  if (question.point_m.size() == 2) return query.nearest(floor_m, filter);
  return query.nearest(Eigen::Vector3d(question.point_m.data()), filter);
}

void keepThoseIn(const std::string& room, const mapping::SemanticMap& map, Objects& objects) {
  const auto rooms = building::roomsOf(map);
  const auto& name = rooms.named(room).name;
  const auto storeys = building::storeysOf(map);
  const auto isElsewhere = [&](const auto* object) {
    return !building::isOnPlan(storeys, object->centroid_m.z()) || building::roomAt(rooms, object->centroid_m) != name;
  };
  objects.erase(std::remove_if(objects.begin(), objects.end(), isElsewhere), objects.end());
}

void addFilters(CLI::App& verb, MapQuestion& question) {
  verb.add_option("--zone", question.zone, "only what stands in this zone");
  verb.add_option("--state", question.state, "static, moved, gone or any; what stands there (static, moved) without")
      ->check(CLI::IsMember({"static", "moved", "gone", "any"}));
  verb.add_flag("--free", question.free, "only what nothing stands on: free chairs, say");
  verb.add_option("--unseen-for", question.unseenFor_s, "only what was last seen so many seconds before the map's end");
  verb.add_option("--seen-within", question.seenWithin_s, "only what was seen in the last so many seconds of the map");
}

CLI::Option* addPoint(CLI::App& verb, MapQuestion& question, int least) {
  return verb.add_option("POINT", question.point_m, "x y z in the map frame, metres")->expected(least, 3)->required();
}

}  // namespace

void answerObjects(const MapQuestion& question, const mapping::SemanticMap& map) {
  const query::MapQuery query(map);
  auto found = query.objects(filterOf(question, map));
  if (!question.room.empty()) keepThoseIn(question.room, map, found);
  show(question.json, toJson(found, map.labels), [&](std::ostream& out) { print(out, found, map.labels); });
}

void answerNearest(const MapQuestion& question, const mapping::SemanticMap& map) {
  const query::MapQuery query(map);
  const auto found = findNearest(question, query, filterOf(question, map));
  nlohmann::ordered_json json = {{"object", nullptr}, {"distance", nullptr}, {"along_floor", question.alongFloor}};
  if (found) {
    json["object"] = toJson(*found->object, map.labels);
    json["distance"] = found->distance_m;
  }
  show(question.json, json, [&](std::ostream& out) {
    if (!found) {
      out << "none\n";
      return;
    }
    print(out, {found->object}, map.labels);
    out << fixed(found->distance_m, 2) << (question.alongFloor ? " m along the floor\n" : " m away\n");
  });
}

void answerPlace(const MapQuestion& question, const mapping::SemanticMap& map) {
  const query::MapQuery query(map);
  const auto place = query.at(Eigen::Vector3d(question.point_m.data()));
  show(question.json, toJson(place, map.labels), [&](std::ostream& out) { print(out, place, map.labels); });
}

void answerZones(const MapQuestion& question, const mapping::SemanticMap& map) {
  const query::MapQuery query(map);
  show(question.json, zonesJson(map, query), [&](std::ostream& out) { printZones(out, map, query); });
}

void addJson(CLI::App& verb, MapQuestion& question) {
  verb.add_flag("--json", question.json, "print JSON instead of a table");
}

void addObjectsOptions(CLI::App& verb, MapQuestion& question) {
  verb.add_option("--class", question.className, "only things of this class, such as chair");
  verb.add_option("--box", question.box_m, "only what reaches into this box: x y z of two corners, metres")
      ->expected(6);
  verb.add_option("--room", question.room, "only what stands in this room, as `map rooms` calls it");
  addFilters(verb, question);
}

void addNearestOptions(CLI::App& verb, MapQuestion& question) {
  verb.add_option("CLASS", question.className, "such as chair")->required();
  addPoint(verb, question, 2)->description("x y [z] in the map frame, metres");
  verb.add_flag("--floor", question.alongFloor, "the shortest way over free floor, not as the crow flies");
  addFilters(verb, question);
}

void addPlaceOptions(CLI::App& verb, MapQuestion& question) { addPoint(verb, question, 3); }

}  // namespace wardslam::apps
