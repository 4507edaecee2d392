#include "map_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "map_export_command.h"
#include "map_merge_command.h"
#include "map_report.h"
#include "map_rooms_command.h"
#include "map_view_command.h"
#include "stored_map.h"
#include "support/table.h"
#include "wardslam/building/rooms_of_map.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/nearest_name.h"
#include "wardslam/query/map_difference.h"
#include "wardslam/query/map_query.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::apps {
namespace {

using storage::CloudPart;
using storage::MapFile;

struct MapArguments {
  std::filesystem::path file;
  std::filesystem::path other;
  std::string className;
  std::string zone;
  std::string room;
  std::string state;
  std::vector<double> box_m;    ///< x0 y0 z0 x1 y1 z1
  std::vector<double> point_m;  ///< x y [z]
  std::optional<double> unseenFor_s;
  std::optional<double> seenWithin_s;
  bool free = false;
  bool alongFloor = false;
  bool json = false;
};

/// Prints JSON or, by `printTable`, what people read.
template <class PrintTable>
void show(const MapArguments& arguments, const nlohmann::ordered_json& json, const PrintTable& printTable) {
  if (arguments.json) {
    std::cout << json.dump(2) << "\n";
  } else {
    printTable(std::cout);
  }
}

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

query::ObjectFilter filterOf(const MapArguments& arguments, const mapping::SemanticMap& map) {
  query::ObjectFilter filter;
  if (!arguments.className.empty()) filter.classId = classNamed(arguments.className, map.labels);
  if (!arguments.zone.empty()) filter.zone = zoneNamed(arguments.zone, map);
  if (!arguments.box_m.empty()) {
    const Eigen::Vector3d first(arguments.box_m.data());
    const Eigen::Vector3d second(arguments.box_m.data() + 3);
    filter.box_m.emplace(first.cwiseMin(second), first.cwiseMax(second));
  }
  filter.unseenAtLeast_s = arguments.unseenFor_s;
  filter.unseenAtMost_s = arguments.seenWithin_s;
  filter.states = statesNamed(arguments.state);
  filter.onlyFree = arguments.free;
  return filter;
}

void info(const MapArguments& arguments) {
  const auto info = MapFile::open(arguments.file).info();
  const auto plan = readStoredMap(arguments.file, CloudPart::LeaveOut).floorPlan;
  show(arguments, toJson(info, plan), [&](std::ostream& out) { print(out, info, plan); });
}

void keepThoseIn(const std::string& room, const mapping::SemanticMap& map, Objects& objects) {
  const auto rooms = building::roomsOf(map);
  const auto& name = rooms.named(room).name;
  const auto isElsewhere = [&](const auto* object) { return building::roomAt(rooms, object->centroid_m) != name; };
  objects.erase(std::remove_if(objects.begin(), objects.end(), isElsewhere), objects.end());
}

void objects(const MapArguments& arguments) {
  const auto map = readStoredMap(arguments.file, CloudPart::LeaveOut);
  const query::MapQuery query(map);
  auto found = query.objects(filterOf(arguments, map));
  if (!arguments.room.empty()) keepThoseIn(arguments.room, map, found);
  show(arguments, toJson(found, map.labels), [&](std::ostream& out) { print(out, found, map.labels); });
}

std::optional<query::NearObject> findNearest(const MapArguments& arguments, const query::MapQuery& query,
                                             const query::ObjectFilter& filter) {
  const Eigen::Vector2d floor_m(arguments.point_m.data());
  if (arguments.alongFloor) return query.nearestAlongFloor(floor_m, filter);
  if (arguments.point_m.size() == 2) return query.nearest(floor_m, filter);
  return query.nearest(Eigen::Vector3d(arguments.point_m.data()), filter);
}

void nearest(const MapArguments& arguments) {
  const auto map = readStoredMap(arguments.file, CloudPart::LeaveOut);
  const query::MapQuery query(map);
  const auto found = findNearest(arguments, query, filterOf(arguments, map));
  nlohmann::ordered_json json = {{"object", nullptr}, {"distance", nullptr}, {"along_floor", arguments.alongFloor}};
  if (found) {
    json["object"] = toJson(*found->object, map.labels);
    json["distance"] = found->distance_m;
  }
  show(arguments, json, [&](std::ostream& out) {
    if (!found) {
      out << "none\n";
      return;
    }
    print(out, {found->object}, map.labels);
    out << fixed(found->distance_m, 2) << (arguments.alongFloor ? " m along the floor\n" : " m away\n");
  });
}

void at(const MapArguments& arguments) {
  const auto map = readStoredMap(arguments.file, CloudPart::LeaveOut);
  const query::MapQuery query(map);
  const auto place = query.at(Eigen::Vector3d(arguments.point_m.data()));
  show(arguments, toJson(place, map.labels), [&](std::ostream& out) { print(out, place, map.labels); });
}

void zones(const MapArguments& arguments) {
  const auto map = readStoredMap(arguments.file, CloudPart::LeaveOut);
  const query::MapQuery query(map);
  show(arguments, zonesJson(map, query), [&](std::ostream& out) { printZones(out, map, query); });
}

/// Whether both maps can be asked for places.
bool haveKeyPoints(const MapArguments& arguments) {
  return MapFile::open(arguments.file).info().trackingPoints > 0 &&
         MapFile::open(arguments.other).info().trackingPoints > 0;
}

/// Maps of runs that knew nothing of each other have frames of their own: the places that both show tell how these lie.
void bringIntoOneFrame(const MapArguments& arguments, mapping::SemanticMap& after) {
  if (!haveKeyPoints(arguments)) return;
  const auto alignment = alignWithProgress(arguments.file, arguments.other, {});
  if (!alignment) {
    std::cerr << "wardslam: no place of " << arguments.file.string() << " is found in " << arguments.other.string()
              << ": they are compared as if they had one frame\n";
  } else if (!alignment->haveOneFrame) {
    for (auto& [id, object] : after.objects) query::moveObject(object, alignment->T_a_b);
  }
}

void diff(const MapArguments& arguments) {
  const auto before = readStoredMap(arguments.file, CloudPart::LeaveOut);
  auto after = readStoredMap(arguments.other, CloudPart::LeaveOut);
  bringIntoOneFrame(arguments, after);
  const auto difference = query::difference(before, after);
  show(arguments, toJson(difference, after.labels), [&](std::ostream& out) { print(out, difference, after.labels); });
}

void check(const MapArguments& arguments) {
  const auto problems = MapFile::open(arguments.file).check();
  show(arguments, {{"sound", problems.empty()}, {"problems", problems}}, [&](std::ostream& out) {
    for (const auto& problem : problems) out << problem << "\n";
    if (problems.empty()) out << arguments.file.string() << ": sound\n";
  });
  if (problems.empty()) return;
  throw core::InputError(arguments.file.string() + ": is damaged (" + problems.front() + ")");
}

CLI::App* addVerb(CLI::App& command, const char* name, const char* help, void (*run)(const MapArguments&),
                  const std::shared_ptr<MapArguments>& arguments) {
  CLI::App* verb = command.add_subcommand(name, help);
  verb->add_option("FILE", arguments->file, "a map (.wardmap)")->required();
  verb->add_flag("--json", arguments->json, "print JSON instead of a table");
  verb->callback([arguments, run] { run(*arguments); });
  return verb;
}

void addFilters(CLI::App& verb, MapArguments& arguments) {
  verb.add_option("--zone", arguments.zone, "only what stands in this zone");
  verb.add_option("--state", arguments.state, "static, moved, gone or any; what stands there (static, moved) without")
      ->check(CLI::IsMember({"static", "moved", "gone", "any"}));
  verb.add_flag("--free", arguments.free, "only what nothing stands on: free chairs, say");
  verb.add_option("--unseen-for", arguments.unseenFor_s,
                  "only what was last seen so many seconds before the map's end");
  verb.add_option("--seen-within", arguments.seenWithin_s, "only what was seen in the last so many seconds of the map");
}

CLI::Option* addPoint(CLI::App& verb, MapArguments& arguments, int least) {
  return verb.add_option("POINT", arguments.point_m, "x y z in the map frame, metres")->expected(least, 3)->required();
}

}  // namespace

void addMapCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("map", "Ask a saved map what stands where");
  command->require_subcommand(1);
  const auto arguments = std::make_shared<MapArguments>();

  addVerb(*command, "info", "How much the map holds", info, arguments);

  CLI::App* objectsVerb = addVerb(*command, "objects", "The things in the map", objects, arguments);
  objectsVerb->add_option("--class", arguments->className, "only things of this class, such as chair");
  objectsVerb->add_option("--box", arguments->box_m, "only what reaches into this box: x y z of two corners, metres")
      ->expected(6);
  objectsVerb->add_option("--room", arguments->room, "only what stands in this room, as `map rooms` calls it");
  addFilters(*objectsVerb, *arguments);

  CLI::App* nearestVerb = addVerb(*command, "nearest", "The nearest thing of a class", nearest, arguments);
  nearestVerb->add_option("CLASS", arguments->className, "such as chair")->required();
  addPoint(*nearestVerb, *arguments, 2)->description("x y [z] in the map frame, metres");
  nearestVerb->add_flag("--floor", arguments->alongFloor, "the shortest way over free floor, not as the crow flies");
  addFilters(*nearestVerb, *arguments);

  addPoint(*addVerb(*command, "at", "What is at a point: things, zones, floor", at, arguments), *arguments, 3);
  addVerb(*command, "zones", "The zones and what stands in them", zones, arguments);
  addVerb(*command, "diff", "What moved, is gone or is new from FILE to OTHER, two maps of one place", diff, arguments)
      ->add_option("OTHER", arguments->other,
                   "the later map (.wardmap); where its frame is another, the places that both show tell how it lies")
      ->required();
  addMapRoomsCommand(*command);
  addMapMergeCommands(*command);
  addMapExportCommand(*command);
  addMapViewCommand(*command);
  addVerb(*command, "check", "Whether the whole file can be read and holds together", check, arguments);
}

}  // namespace wardslam::apps
