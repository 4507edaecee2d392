#include "zone_rows.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "map_rows.h"

namespace wardslam::storage {
namespace {

// What is beyond is no speed and no angle.
constexpr double kMostSpeed_mps = 1e3;
constexpr double kMostDirection_rad = 1e3;

std::vector<std::string>* actionsOf(mapping::ZoneActions& actions, const std::string& moment) {
  return moment == "entry"    ? &actions.entry
         : moment == "inside" ? &actions.inside
         : moment == "exit"   ? &actions.exit
                              : nullptr;
}

void readZoneActions(SQLite::Database& database, std::map<std::uint32_t, mapping::Zone>& zones) {
  forEachRow(database, "zone",
             "SELECT zone, moment, position, action FROM zone_actions ORDER BY zone, moment, position",
             [&zones](ColumnReader row) {
               std::uint32_t id = 0;
               std::string moment;
               std::string action;
               std::uint32_t position = 0;
               row >> id >> moment >> position >> action;
               const auto zone = zones.find(id);
               if (zone == zones.end()) throw core::BlobError("it has actions and is not there");
               auto* const actions = actionsOf(zone->second.actions, moment);
               if (actions == nullptr) throw core::BlobError("it has an action at no known moment");
               if (position != actions->size()) throw core::BlobError("an action of it is missing");
               actions->push_back(std::move(action));
             });
}

void writeZoneActions(SQLite::Database& database, std::uint32_t zone, const mapping::ZoneActions& actions) {
  SQLite::Statement row(database, "INSERT INTO zone_actions VALUES (?,?, ?,?)");
  const auto write = [&row, zone](const char* moment, const std::vector<std::string>& names) {
    std::uint32_t position = 0;
    for (const std::string& name : names) (ParameterBinder(row) << zone << moment << position++ << name).run();
  };
  write("entry", actions.entry);
  write("inside", actions.inside);
  write("exit", actions.exit);
}

}  // namespace

std::vector<mapping::Zone> readZones(SQLite::Database& database) {
  std::map<std::uint32_t, mapping::Zone> zones;
  forEachRow(database, "zone", "SELECT id, name, type, max_speed_mps, direction_rad FROM zones ORDER BY id",
             [&zones](ColumnReader row) {
               std::uint32_t id = 0;
               mapping::Zone zone;
               std::string type;
               row >> id >> zone.name >> type >> within(zone.maxSpeed_mps, 0.0, kMostSpeed_mps);
               row >> within(zone.direction_rad, -kMostDirection_rad, kMostDirection_rad);
               if (zone.name.empty()) throw core::BlobError("it has no name");
               const auto known = mapping::zoneTypeFrom(type);
               if (!known) throw core::BlobError("it is of no known type");
               zone.type = *known;
               zones[id] = std::move(zone);
             });
  readZoneActions(database, zones);
  forEachRow(database, "zone", "SELECT zone, x_m, y_m FROM zone_corners ORDER BY zone, position",
             [&zones](ColumnReader row) {
               std::uint32_t id = 0;
               Eigen::Vector2d corner_m;
               row >> id >> corner_m;
               const auto zone = zones.find(id);
               if (zone == zones.end()) throw core::BlobError("it has corners and is not there");
               zone->second.polygon_m.push_back(corner_m);
             });
  std::vector<mapping::Zone> inOrder;
  inOrder.reserve(zones.size());
  for (auto& [id, zone] : zones) inOrder.push_back(std::move(zone));
  return inOrder;
}

void writeZones(SQLite::Database& database, const std::vector<mapping::Zone>& zones) {
  database.exec("DELETE FROM zone_actions; DELETE FROM zone_corners; DELETE FROM zones");
  SQLite::Statement zoneRow(database, "INSERT INTO zones VALUES (?,?, ?,?,?)");
  SQLite::Statement cornerRow(database, "INSERT INTO zone_corners VALUES (?,?, ?,?)");
  std::uint32_t id = 0;
  for (const auto& zone : zones) {
    (ParameterBinder(zoneRow) << ++id << zone.name << mapping::toString(zone.type) << zone.maxSpeed_mps
                              << zone.direction_rad)
        .run();
    writeZoneActions(database, id, zone.actions);
    std::uint32_t position = 0;
    for (const auto& corner : zone.polygon_m) (ParameterBinder(cornerRow) << id << position++ << corner).run();
  }
}

}  // namespace wardslam::storage
