#include <ctime>
#include <nlohmann/json.hpp>
#include <optional>

#include "newest_stamp.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/exchange/fleet_export.h"

namespace wardslam::exchange {
namespace {

using Json = nlohmann::ordered_json;
using mapping::Zone;
using mapping::ZoneType;

/// VDA 5050 3.0.0, chapter 6.4: zoneType. Nothing: places ask for nothing.
std::optional<std::string> typeOf(const Zone& zone) {
  switch (zone.type) {
    case ZoneType::Place:
      return std::nullopt;
    case ZoneType::Forbidden:
      return "BLOCKED";
    case ZoneType::Slow:
      return "SPEED_LIMIT";
    case ZoneType::OneWay:
      return "DIRECTED";
    case ZoneType::Action:
      return "ACTION";
    case ZoneType::Release:
      return "RELEASE";
  }
  return std::nullopt;
}

/// NONE: robots go on driving meanwhile, for zones tell of no place to stop at.
Json actionsOf(const std::vector<std::string>& names) {
  Json actions = Json::array();
  for (const std::string& name : names) actions.push_back({{"actionType", name}, {"blockingType", "NONE"}});
  return actions;
}

Json zoneOf(const Zone& zone, const std::string& type) {
  Json json = {{"zoneId", zone.name}, {"zoneType", type}, {"zoneDescriptor", zone.name}, {"vertices", Json::array()}};
  for (const auto& corner_m : zone.polygon_m) json["vertices"].push_back({{"x", corner_m.x()}, {"y", corner_m.y()}});
  if (zone.type == ZoneType::Slow) json["maximumSpeed"] = zone.maxSpeed_mps;
  if (zone.type == ZoneType::OneWay) {
    json["direction"] = std::remainder(zone.direction_rad, 2.0 * M_PI);
    json["limitation"] = "RESTRICTED";
  }
  if (zone.type == ZoneType::Action) {
    json["entryActions"] = actionsOf(zone.actions.entry);
    json["duringActions"] = actionsOf(zone.actions.inside);
    json["exitActions"] = actionsOf(zone.actions.exit);
  }
  return json;
}

}  // namespace

void exportZoneSet(const mapping::SemanticMap& map, const std::string& id, const std::filesystem::path& file) {
  Json zones = Json::array();
  for (const Zone& zone : map.zones) {
    if (const auto type = typeOf(zone)) zones.push_back(zoneOf(zone, *type));
  }
  const Json message = {
      {"headerId", 0},      {"timestamp", newestStampOf(map)},
      {"version", "3.0.0"}, {"manufacturer", "WardSLAM"},
      {"serialNumber", ""}, {"zoneSet", {{"mapId", id}, {"zoneSetId", id + " zones"}, {"zones", zones}}}};
  core::writeFileAtomically(file, message.dump(1) + "\n");
}

}  // namespace wardslam::exchange
