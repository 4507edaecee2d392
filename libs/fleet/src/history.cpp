#include "wardslam/fleet/history.h"

#include <algorithm>

#include "session.h"
#include "wardslam/core/nearest_name.h"

namespace wardslam::fleet {
namespace {

constexpr const char* kColumns =
    "site, storeys.name AS storey, robots.name AS robot, maps.name AS map_name, o.number, coalesce(labels.name, '') AS "
    "class, s.since_s, s.until_s, coalesce(s.ended, '') AS ended, coalesce(s.ended_s, 0) AS ended_s, ST_X(s.place), "
    "ST_Y(s.place), ST_Z(s.place), ST_XMin(s.box), ST_YMin(s.box), ST_ZMin(s.box), ST_XMax(s.box), ST_YMax(s.box), "
    "ST_ZMax(s.box), s.zone, coalesce(room_at(s.map, s.place), '') AS room";

/// Of sightings s of objects o.
constexpr const char* kNames =
    " JOIN maps ON maps.id = s.map JOIN storeys ON storeys.id = maps.storey JOIN robots ON robots.id = maps.robot "
    "LEFT JOIN labels ON labels.map = o.map AND labels.class_id = o.class_id ";
/// $1 to $4 are the choice of maps.
constexpr const char* kChosen =
    "($1 = '' OR site = $1) AND ($2 = '' OR storeys.name = $2) AND ($3 = '' OR robots.name = $3) "
    "AND ($4 = '' OR maps.name = $4) ";

/// Where it stood next.
constexpr const char* kNext =
    "LEFT JOIN LATERAL (SELECT n.map, n.place, n.zone FROM sightings n WHERE n.map = s.map AND n.object = s.object AND "
    "n.since_s > s.since_s ORDER BY n.since_s LIMIT 1) n ON true ";

Eigen::Vector3d pointAt(const pqxx::row& row, int column) {
  const auto number = [&](int i) { return row[static_cast<pqxx::row::size_type>(column + i)].as<double>(); };
  return {number(0), number(1), number(2)};
}

Whereabouts whereaboutsOf(const pqxx::row& row) {
  Whereabouts found;
  found.site = row[0].as<std::string>();
  found.storey = row[1].as<std::string>();
  found.robot = row[2].as<std::string>();
  found.map = row[3].as<std::string>();
  found.object = row[4].as<mapping::ObjectId>();
  found.className = row[5].as<std::string>();
  found.since_s = row[6].as<double>();
  found.until_s = row[7].as<double>();
  found.ended = row[8].as<std::string>();
  found.ended_s = row[9].as<double>();
  found.place_m = pointAt(row, 10);
  found.box_m = {pointAt(row, 13), pointAt(row, 16)};
  found.zone = row[19].as<std::string>();
  found.room = row[20].as<std::string>();
  if (row.size() > 21 && !row[21].is_null()) found.next = row[21].as<std::string>();
  return found;
}

template <class... Arguments>
std::vector<Whereabouts> findIn(pqxx::transaction_base& transaction, const std::string& sql, const MapChoice& choice,
                                const Arguments&... arguments) {
  std::vector<Whereabouts> found;
  const auto rows = execute(transaction, sql, choice.site, choice.storey, choice.robot, choice.name, arguments...);
  for (const auto& row : rows) {
    found.push_back(whereaboutsOf(row));
  }
  return found;
}

template <class... Arguments>
std::vector<Whereabouts> find(const std::string& url, const std::string& sql, const MapChoice& choice,
                              const Arguments&... arguments) {
  return inTransaction(url, Isolation::OneMoment, [&](pqxx::transaction_base& transaction) {
    return findIn(transaction, sql, choice, arguments...);
  });
}

/// The sightings s of the chosen maps that meet the condition. Map by map, for the planner would rather read all there
/// are.
std::string ofChosenMaps(const std::string& columns, const std::string& condition) {
  return std::string(
             "WITH chosen AS MATERIALIZED (SELECT maps.id FROM maps JOIN storeys ON storeys.id = maps.storey "
             "JOIN robots ON robots.id = maps.robot WHERE ") +
         kChosen + ") SELECT " + columns +
         " FROM chosen CROSS JOIN LATERAL (SELECT * FROM sightings WHERE sightings.map = chosen.id AND " + condition +
         " OFFSET 0) s JOIN objects o ON o.map = s.map AND o.number = s.object" + kNames;
}

/// $5 is its name, $6 since when.
std::string leavingAZone() {
  return ofChosenMaps(std::string(kColumns) + ", CASE WHEN s.ended = 'moved' THEN n.zone END",
                      "ended IS NOT NULL AND ended_s >= $6") +
         "JOIN zones z ON z.map = s.map AND z.name = $5 AND ST_Intersects(z.area, s.place) " + kNext +
         "WHERE s.ended = 'gone' OR NOT ST_Intersects(z.area, n.place) ORDER BY s.ended_s, robot, map_name, o.number";
}

std::string leavingARoom() {
  return ofChosenMaps(
             std::string(kColumns) + ", CASE WHEN s.ended = 'moved' THEN coalesce(room_at(n.map, n.place), '') END",
             "ended IS NOT NULL AND ended_s >= $6") +
         "JOIN rooms r ON r.map = s.map AND r.name = $5 AND ST_DWithin(r.area, s.place, 0.5) " + kNext +
         "WHERE room_at(s.map, s.place) = $5 "
         "AND (s.ended = 'gone' OR room_at(n.map, n.place) IS DISTINCT FROM $5) "
         "ORDER BY s.ended_s, robot, map_name, o.number";
}

/// `table`: zones or rooms.
std::vector<std::string> namesIn(pqxx::transaction_base& transaction, const std::string& table,
                                 const MapChoice& choice) {
  std::vector<std::string> names;
  const auto rows = execute(transaction,
                            "SELECT DISTINCT p.name FROM " + table +
                                " p JOIN maps ON maps.id = p.map JOIN storeys ON storeys.id = maps.storey "
                                "JOIN robots ON robots.id = maps.robot WHERE " +
                                kChosen + "ORDER BY p.name",
                            choice.site, choice.storey, choice.robot, choice.name);
  for (const auto& row : rows) names.push_back(row[0].as<std::string>());
  return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string leaving(pqxx::transaction_base& transaction, const MapChoice& choice, const std::string& place) {
  auto names = namesIn(transaction, "zones", choice);
  if (contains(names, place)) return leavingAZone();
  const auto rooms = namesIn(transaction, "rooms", choice);
  if (contains(rooms, place)) return leavingARoom();
  names.insert(names.end(), rooms.begin(), rooms.end());
  if (names.empty()) throw core::InputError("these maps have no zones and no rooms, so none called '" + place + "'");
  throw core::InputError("no zone or room is called '" + place + "'; did you mean '" + core::nearestName(place, names) +
                         "'?");
}

}  // namespace

std::vector<Whereabouts> whereWas(const std::string& url, const MapChoice& choice, const std::string& className,
                                  mapping::ObjectId object, double at_s) {
  // Step by step, for the planner would rather read all sightings there are.
  const std::string sql =
      std::string(
          "WITH asked AS MATERIALIZED (SELECT DISTINCT o.thing FROM maps JOIN storeys ON storeys.id = "
          "maps.storey JOIN robots ON robots.id = maps.robot JOIN objects o ON o.map = maps.id AND o.number = $5 "
          "LEFT JOIN labels ON labels.map = o.map AND labels.class_id = o.class_id WHERE ") +
      kChosen +
      "AND ($6 = '' OR labels.name = $6)), same AS MATERIALIZED (SELECT o.* FROM asked CROSS JOIN LATERAL (SELECT * "
      "FROM "
      "objects WHERE objects.thing = asked.thing OFFSET 0) o) SELECT " +
      kColumns +
      " FROM same o CROSS JOIN LATERAL (SELECT * FROM sightings s WHERE s.map = o.map AND s.object = o.number AND "
      "s.since_s <= $7 ORDER BY s.since_s DESC LIMIT 1) s" +
      kNames + "WHERE o.in_map OR s.until_s >= $7 ORDER BY least(s.until_s, $7) DESC, robot, map_name";
  return find(url, sql, choice, object, className, at_s);
}

std::vector<Whereabouts> whatStood(const std::string& url, const MapChoice& choice, const Eigen::Vector3d& p_map_m,
                                   double radius_m, double at_s) {
  const std::string sql = ofChosenMaps(kColumns,
                                       "ST_3DDWithin(place, ST_MakePoint($5, $6, $7), $8) AND since_s <= $9 "
                                       "AND (ended IS NULL OR ended_s > $9)") +
                          "WHERE o.in_map OR s.until_s >= $9 ORDER BY robot, map_name, o.number";
  return find(url, sql, choice, p_map_m.x(), p_map_m.y(), p_map_m.z(), radius_m, at_s);
}

std::vector<Whereabouts> whatLeft(const std::string& url, const MapChoice& choice, const std::string& place,
                                  double since_s) {
  return inTransaction(url, Isolation::OneMoment, [&](pqxx::transaction_base& transaction) {
    return findIn(transaction, leaving(transaction, choice, place), choice, place, since_s);
  });
}

}  // namespace wardslam::fleet
