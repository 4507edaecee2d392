#include "map_report.h"

#include <ctime>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <ostream>
#include <string>

#include "support/table.h"

namespace wardslam::apps {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

const char* floorName(unsigned char cell) {
  if (cell == mapping::FloorPlan::kFree) return "free";
  return cell == mapping::FloorPlan::kOccupied ? "occupied" : "unknown";
}

double area_m2(const mapping::FloorPlan& plan, unsigned char kind) {
  const int cells = plan.cells.empty() ? 0 : cv::countNonZero(plan.cells == kind);
  return cells * plan.resolution_m * plan.resolution_m;
}

std::string timeText(double stamp_s) {
  const auto seconds = static_cast<std::time_t>(stamp_s);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  std::string text(sizeof "2000-01-01 00:00:00 UTC", '\0');
  text.resize(std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S UTC", &utc));
  return text;
}

std::string positionText(const Eigen::Vector3d& p) {
  return fixed(p.x(), 2) + " " + fixed(p.y(), 2) + " " + fixed(p.z(), 2);
}

std::size_t keyframesIn(const mapping::SemanticMap& map, const std::string& zone) {
  std::size_t count = 0;
  for (const auto& [id, keyframe] : map.keyframes) count += keyframe.zone == zone ? 1 : 0;
  return count;
}

std::size_t objectsIn(const query::MapQuery& query, const std::string& zone) {
  query::ObjectFilter filter;
  filter.zone = zone;
  return query.objects(filter).size();
}

Json toJson(const std::vector<storage::PieceInfo>& parts) {
  Json list = Json::array();
  for (const auto& part : parts) {
    list.push_back({{"piece", part.piece},
                    {"is_map", part.isMap},
                    {"keyframes", part.keyframes},
                    {"first_stamp", part.firstStamp_s},
                    {"last_stamp", part.lastStamp_s},
                    {"from", part.from}});
  }
  return list;
}

}  // namespace

Json toJson(const storage::MapFileInfo& info, const mapping::FloorPlan& plan) {
  return {{"schema_version", info.schemaVersion},
          {"size_bytes", info.size_bytes},
          {"pieces", info.pieces},
          {"parts", toJson(info.parts)},
          {"keyframes_unjoined", info.keyframesElsewhere},
          {"keyframes", info.keyframes},
          {"first_stamp", info.firstStamp_s},
          {"last_stamp", info.lastStamp_s},
          {"tracking_points", info.trackingPoints},
          {"loops", info.loops},
          {"cloud_points", info.cloudPoints},
          {"objects", info.objects},
          {"zones", info.zones},
          {"floor_free_m2", area_m2(plan, mapping::FloorPlan::kFree)},
          {"floor_occupied_m2", area_m2(plan, mapping::FloorPlan::kOccupied)}};
}

Json toJson(const mapping::MapObject& object, const core::LabelSpace& labels) {
  Json json{{"id", object.id},
            {"class_id", object.classId},
            {"class_name", labels.name(object.classId)},
            {"centroid", toJson(object.centroid_m)},
            {"box_min", toJson(object.box_m.min())},
            {"box_max", toJson(object.box_m.max())},
            {"probability", object.probability},
            {"views", object.views},
            {"zone", object.zone},
            {"state", toString(object.state)}};
  if (object.maybeSameAs) {
    json["maybe_same_as"] = {{"id", object.maybeSameAs->id}, {"probability", object.maybeSameAs->probability}};
  }
  return json;
}

Json toJson(const Objects& objects, const core::LabelSpace& labels) {
  Json list = Json::array();
  for (const auto* object : objects) list.push_back(toJson(*object, labels));
  return {{"objects", list}};
}

Json toJson(const query::Place& place, const core::LabelSpace& labels) {
  Json json = toJson(place.objects, labels);
  json["zones"] = place.zones;
  json["floor"] = floorName(place.floor);
  return json;
}

Json toJson(const query::MapDifference& difference, const core::LabelSpace& labels) {
  Json moved = Json::array();
  for (const auto& pair : difference.moved) {
    moved.push_back({{"before", toJson(*pair.before, labels)},
                     {"after", toJson(*pair.after, labels)},
                     {"distance", pair.distance_m}});
  }
  return {{"moved", moved},
          {"gone", toJson(difference.gone, labels)["objects"]},
          {"new", toJson(difference.added, labels)["objects"]},
          {"unchanged", difference.unchanged}};
}

namespace {

constexpr double kDegreesPerRadian = 180.0 / M_PI;

/// What a zone of its type asks, by the keys of zones files.
void addRule(Json& json, const mapping::Zone& zone) {
  if (zone.type == mapping::ZoneType::Slow) json["max_speed_mps"] = zone.maxSpeed_mps;
  if (zone.type == mapping::ZoneType::OneWay) json["direction_deg"] = kDegreesPerRadian * zone.direction_rad;
  if (zone.type != mapping::ZoneType::Action) return;
  json["on_entry"] = zone.actions.entry;
  json["inside"] = zone.actions.inside;
  json["on_exit"] = zone.actions.exit;
}

std::string ruleText(const mapping::Zone& zone) {
  std::string text = mapping::toString(zone.type);
  if (zone.type == mapping::ZoneType::Slow) text += ", " + fixed(zone.maxSpeed_mps, 2) + " m/s";
  if (zone.type == mapping::ZoneType::OneWay) text += ", " + fixed(kDegreesPerRadian * zone.direction_rad, 0) + " deg";
  return text;
}

}  // namespace

Json zonesJson(const mapping::SemanticMap& map, const query::MapQuery& query) {
  Json list = Json::array();
  for (const auto& zone : map.zones) {
    Json polygon = Json::array();
    for (const auto& corner : zone.polygon_m) polygon.push_back({corner.x(), corner.y()});
    list.push_back({{"name", zone.name},
                    {"type", mapping::toString(zone.type)},
                    {"area_m2", area_m2(zone)},
                    {"objects", objectsIn(query, zone.name)},
                    {"keyframes", keyframesIn(map, zone.name)},
                    {"polygon", polygon}});
    addRule(list.back(), zone);
  }
  return {{"zones", list}};
}

void print(std::ostream& out, const storage::MapFileInfo& info, const mapping::FloorPlan& plan) {
  constexpr double kBytesPerMegabyte = 1e6;
  Table table({"", ""});
  table.add({"keyframes", std::to_string(info.keyframes)});
  if (info.keyframes > 0) {
    table.add({"  from", timeText(info.firstStamp_s)});
    table.add({"  to", timeText(info.lastStamp_s)});
  }
  if (info.keyframesElsewhere > 0) {
    table.add({"pieces not joined", std::to_string(info.pieces - 1)});
    table.add({"  keyframes", std::to_string(info.keyframesElsewhere)});
  }
  for (const auto& part : info.parts) {
    if (part.from.empty()) continue;
    table.add({part.isMap ? "the map is of" : "a part by itself is of",
               part.from + " (" + std::to_string(part.keyframes) + " keyframes)"});
  }
  table.add({"loops", std::to_string(info.loops)});
  table.add({"tracking points", std::to_string(info.trackingPoints)});
  table.add({"cloud points", std::to_string(info.cloudPoints)});
  table.add({"objects", std::to_string(info.objects)});
  table.add({"zones", std::to_string(info.zones)});
  table.add({"free floor", fixed(area_m2(plan, mapping::FloorPlan::kFree), 1) + " m2"});
  table.add({"file size", fixed(static_cast<double>(info.size_bytes) / kBytesPerMegabyte, 2) + " MB"});
  table.add({"schema version", std::to_string(info.schemaVersion)});
  table.print(out);
}

void print(std::ostream& out, const Objects& objects, const core::LabelSpace& labels) {
  Table table({"id", "class", "probability", "centroid [m]", "size [m]", "views", "zone", "state"});
  for (const auto* object : objects) {
    table.add({std::to_string(object->id), labels.name(object->classId), fixed(object->probability, 2),
               positionText(object->centroid_m), positionText(object->box_m.sizes()), std::to_string(object->views),
               object->zone, toString(object->state)});
  }
  table.print(out);
}

void print(std::ostream& out, const query::Place& place, const core::LabelSpace& labels) {
  out << "floor: " << floorName(place.floor) << "\nzones:";
  for (const auto& zone : place.zones) out << " " << zone;
  out << (place.zones.empty() ? " none\n" : "\n");
  if (place.objects.empty()) {
    out << "objects: none\n";
  } else {
    print(out, place.objects, labels);
  }
}

void print(std::ostream& out, const query::MapDifference& difference, const core::LabelSpace& labels) {
  Table table({"change", "class", "from [m]", "to [m]", "distance [m]"});
  for (const auto& [before, after, distance_m] : difference.moved) {
    table.add({"moved", labels.name(before->classId), positionText(before->centroid_m), positionText(after->centroid_m),
               fixed(distance_m, 2)});
  }
  for (const auto* object : difference.gone) {
    table.add({"gone", labels.name(object->classId), positionText(object->centroid_m), "", ""});
  }
  for (const auto* object : difference.added) {
    table.add({"new", labels.name(object->classId), "", positionText(object->centroid_m), ""});
  }
  table.print(out);
  out << difference.unchanged << " unchanged\n";
}

void printZones(std::ostream& out, const mapping::SemanticMap& map, const query::MapQuery& query) {
  Table table({"zone", "type", "area [m2]", "objects", "keyframes"});
  for (const auto& zone : map.zones) {
    table.add({zone.name, ruleText(zone), fixed(area_m2(zone), 1), std::to_string(objectsIn(query, zone.name)),
               std::to_string(keyframesIn(map, zone.name))});
  }
  table.print(out);
}

}  // namespace wardslam::apps
