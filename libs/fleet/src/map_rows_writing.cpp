#include "map_rows_writing.h"

#include <algorithm>
#include <iterator>
#include <opencv2/core.hpp>
#include <set>
#include <string_view>

#include "digest.h"
#include "zone_rules.h"

namespace wardslam::fleet {
namespace {

/// Keyframes further apart are of two runs.
constexpr double kPause_s = 600.0;

std::map<std::uint64_t, int> runsOf(const std::map<std::uint64_t, mapping::MappedKeyframe>& keyframes) {
  std::vector<std::pair<double, std::uint64_t>> byStamp;
  for (const auto& [number, keyframe] : keyframes) byStamp.emplace_back(keyframe.stamp_s, number);
  std::sort(byStamp.begin(), byStamp.end());
  std::map<std::uint64_t, int> runs;
  int run = 1;
  for (std::size_t i = 0; i < byStamp.size(); ++i) {
    if (i > 0 && byStamp[i].first - byStamp[i - 1].first > kPause_s) ++run;
    runs[byStamp[i].second] = run;
  }
  return runs;
}

std::map<std::uint64_t, std::string> digestsIn(pqxx::transaction_base& transaction, const std::string& sql,
                                               std::int64_t map) {
  std::map<std::uint64_t, std::string> digests;
  for (const auto& row : execute(transaction, sql, map)) {
    digests.emplace(row[0].as<std::uint64_t>(), row[1].as<std::string>());
  }
  return digests;
}

/// Leaves in `stored` what is there and not in the map any more.
Json changedRows(std::vector<Json> rows, std::map<std::uint64_t, std::string>& stored) {
  Json changed = Json::array();
  for (auto& row : rows) {
    const auto found = stored.find(row["number"].get<std::uint64_t>());
    const bool isThere = found != stored.end();
    if (!isThere || found->second != row["digest"].get_ref<const std::string&>()) changed.push_back(std::move(row));
    if (isThere) stored.erase(found);
  }
  return changed;
}

std::vector<std::uint64_t> numbersOf(const std::map<std::uint64_t, std::string>& digests) {
  std::vector<std::uint64_t> numbers;
  for (const auto& entry : digests) numbers.push_back(entry.first);
  return numbers;
}

void rebuildRuns(pqxx::transaction_base& transaction, std::int64_t map) {
  execute(transaction, "DELETE FROM runs WHERE map = $1", map);
  execute(transaction,
          "INSERT INTO runs (map, number, first_s, last_s, keyframes, way) "
          "SELECT map, run, min(stamp_s), max(stamp_s), count(*), CASE WHEN count(*) > 1 THEN "
          "ST_MakeLine(ST_MakePoint(ST_X(place), ST_Y(place), ST_Z(place), stamp_s) ORDER BY stamp_s) END "
          "FROM keyframes WHERE map = $1 GROUP BY map, run",
          map);
}

bool areEqual(const std::vector<mapping::Zone>& a, const std::vector<mapping::Zone>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const mapping::Zone& x, const mapping::Zone& y) {
    return x.name == y.name && x.polygon_m == y.polygon_m && ruleOf(x) == ruleOf(y);
  });
}

/// Where a thing of the earlier state of a map is in the new one: as the keyframe nearest to it was moved.
class Corrections {
 public:
  Corrections(pqxx::transaction_base& transaction, std::int64_t map, const mapping::SemanticMap& now)
      : now_(now), before_(readKeyframes(transaction, map)) {}

  [[nodiscard]] Eigen::Vector3d apply(const Eigen::Vector3d& p_before_m) const {
    const mapping::MappedKeyframe* from = nullptr;
    const mapping::MappedKeyframe* to = nullptr;
    for (const auto& [number, keyframe] : before_) {
      const auto found = now_.keyframes.find(number);
      if (found == now_.keyframes.end()) continue;
      if (from != nullptr && distance_m(keyframe, p_before_m) >= distance_m(*from, p_before_m)) continue;
      from = &keyframe;
      to = &found->second;
    }
    return from == nullptr ? p_before_m : to->T_map_cam * (from->T_map_cam.inverse() * p_before_m);
  }

 private:
  [[nodiscard]] static double distance_m(const mapping::MappedKeyframe& keyframe, const Eigen::Vector3d& p_m) {
    return (keyframe.T_map_cam.translation() - p_m).norm();
  }

  const mapping::SemanticMap& now_;
  std::map<std::uint64_t, mapping::MappedKeyframe> before_;
};

Change changeOf(const mapping::MapObject& object, const std::optional<Stay>& before, const StayUpdate& update) {
  const Stay& now = update.next ? *update.next : *update.last;
  const double at_s = update.change == "gone" ? now.ended_s : now.since_s;
  return {object.id, update.change, at_s, now.place_m, now.zone, before ? before->zone : std::string()};
}

constexpr const char* kRowsOfStays =
    "json_to_recordset($2::json) AS n(object bigint, since_s float8, until_s float8, x float8, y float8, z float8, "
    "x0 float8, y0 float8, z0 float8, x1 float8, y1 float8, z1 float8, zone text, ended text, ended_s float8)";
constexpr const char* kBox = "ST_Collect(ST_MakePoint(n.x0, n.y0, n.z0), ST_MakePoint(n.x1, n.y1, n.z1))";

}  // namespace

void writeLabels(pqxx::transaction_base& transaction, std::int64_t map, const core::LabelSpace& labels) {
  const auto names = namesOf(labels);
  if (names == namesOf(readLabels(transaction, map))) return;
  Json rows = Json::array();
  for (const auto& [id, name] : names) rows.push_back({{"class_id", id}, {"name", name}});
  execute(transaction, "DELETE FROM labels WHERE map = $1", map);
  execute(transaction,
          "INSERT INTO labels (map, class_id, name) SELECT $1, n.class_id, n.name "
          "FROM json_to_recordset($2::json) AS n(class_id smallint, name text)",
          map, parameterOf(rows));
}

void writeZones(pqxx::transaction_base& transaction, std::int64_t map, const std::vector<mapping::Zone>& zones) {
  if (areEqual(zones, readZones(transaction, map))) return;
  execute(transaction, "DELETE FROM zones WHERE map = $1", map);
  for (std::size_t i = 0; i < zones.size(); ++i) {
    Json ring = Json::array();
    for (const auto& corner : zones[i].polygon_m) ring.push_back({{"x", corner.x()}, {"y", corner.y()}});
    ring.push_back(ring.front());
    execute(transaction,
            "INSERT INTO zones (map, position, name, rule, area) SELECT $1, $2, $3, $5::json, "
            "ST_MakePolygon(ST_MakeLine(ST_MakePoint((corner->>'x')::float8, (corner->>'y')::float8) ORDER BY number)) "
            "FROM json_array_elements($4::json) WITH ORDINALITY AS corners(corner, number)",
            map, i, zones[i].name, parameterOf(ring), ruleOf(zones[i]).dump());
  }
}

void writeRooms(pqxx::transaction_base& transaction, std::int64_t map, const building::Rooms& rooms) {
  auto stored = digestsIn(transaction, "SELECT number, digest FROM rooms WHERE map = $1", map);
  std::vector<Json> rows;
  for (const auto& room : rooms.all) rows.push_back(rowOf(room));
  const Json changed = changedRows(std::move(rows), stored);
  execute(transaction, "DELETE FROM rooms WHERE map = $1 AND number = ANY ($2::bigint[])", map,
          arrayOf(numbersOf(stored)));
  execute(
      transaction,  // an outline may touch itself
      "INSERT INTO rooms (map, number, name, area, digest) SELECT $1, n.number, n.name, "
      "ST_Multi(ST_CollectionExtract(ST_MakeValid(ST_GeomFromText(n.area)), 3)), n.digest "
      "FROM json_to_recordset($2::json) AS n(number integer, name text, area text, digest text) "
      "ON CONFLICT (map, number) DO UPDATE SET name = EXCLUDED.name, area = EXCLUDED.area, digest = EXCLUDED.digest",
      map, parameterOf(changed));
}

void writeFloorPlan(pqxx::transaction_base& transaction, std::int64_t map, const mapping::FloorPlan& plan) {
  if (plan.cells.empty()) return;
  const cv::Mat cells = plan.cells.isContinuous() ? plan.cells : plan.cells.clone();
  const std::string_view bytes(cells.ptr<char>(), cells.total());
  const Json place = {plan.resolution_m, plan.origin_m.x(), plan.origin_m.y(), cells.rows, cells.cols};
  const std::string digest = digestOf(parameterOf(place) + digestOf(bytes));
  const auto stored = execute(transaction, "SELECT digest FROM floor_plans WHERE map = $1", map);
  if (!stored.empty() && stored[0][0].as<std::string>() == digest) return;
  execute(transaction,
          "INSERT INTO floor_plans (map, resolution_m, origin_x_m, origin_y_m, rows, columns, digest, cells) "
          "VALUES ($1, $2, $3, $4, $5, $6, $7, $8) ON CONFLICT (map) DO UPDATE SET resolution_m = "
          "EXCLUDED.resolution_m, origin_x_m = EXCLUDED.origin_x_m, origin_y_m = EXCLUDED.origin_y_m, rows = "
          "EXCLUDED.rows, columns = EXCLUDED.columns, digest = EXCLUDED.digest, cells = EXCLUDED.cells",
          map, plan.resolution_m, plan.origin_m.x(), plan.origin_m.y(), cells.rows, cells.cols, digest,
          bytesParameter(bytes));
}

std::size_t writeKeyframes(pqxx::transaction_base& transaction, std::int64_t map,
                           const std::map<std::uint64_t, mapping::MappedKeyframe>& keyframes) {
  auto stored = digestsIn(transaction, "SELECT number, digest FROM keyframes WHERE map = $1", map);
  const auto runs = runsOf(keyframes);
  std::vector<Json> rows;
  for (const auto& [number, keyframe] : keyframes) rows.push_back(rowOf(number, keyframe, runs.at(number)));
  const Json changed = changedRows(std::move(rows), stored);
  if (changed.empty() && stored.empty()) return 0;
  execute(transaction, "DELETE FROM keyframes WHERE map = $1 AND number = ANY ($2::bigint[])", map,
          arrayOf(numbersOf(stored)));
  execute(transaction,
          "INSERT INTO keyframes (map, number, run, stamp_s, place, qx, qy, qz, qw, zone, digest) "
          "SELECT $1, n.number, n.run, n.stamp_s, ST_MakePoint(n.x, n.y, n.z), n.qx, n.qy, n.qz, n.qw, n.zone, "
          "n.digest FROM json_to_recordset($2::json) AS n(number bigint, run integer, stamp_s float8, x float8, "
          "y float8, z float8, qx float8, qy float8, qz float8, qw float8, zone text, digest text) "
          "ON CONFLICT (map, number) DO UPDATE SET run = EXCLUDED.run, stamp_s = EXCLUDED.stamp_s, place = "
          "EXCLUDED.place, qx = EXCLUDED.qx, qy = EXCLUDED.qy, qz = EXCLUDED.qz, qw = EXCLUDED.qw, zone = "
          "EXCLUDED.zone, digest = EXCLUDED.digest",
          map, parameterOf(changed));
  rebuildRuns(transaction, map);
  return changed.size();
}

std::size_t writeObjects(pqxx::transaction_base& transaction, std::int64_t map, std::int64_t parent,
                         const std::map<mapping::ObjectId, mapping::MapObject>& objects) {
  auto stored = digestsIn(transaction, "SELECT number, digest FROM objects WHERE map = $1 AND in_map", map);
  std::vector<Json> rows;
  for (const auto& [number, object] : objects) rows.push_back(rowOf(object));
  const Json changed = changedRows(std::move(rows), stored);
  execute(transaction, "UPDATE objects SET in_map = false WHERE map = $1 AND number = ANY ($2::bigint[])", map,
          arrayOf(numbersOf(stored)));
  execute(transaction,
          std::string(
              "INSERT INTO objects (map, number, thing, in_map, class_id, probability, place, box, box_x_m, box_y_m, "
              "box_z_m, box_qx, box_qy, box_qz, box_qw, box_length_m, box_width_m, box_height_m, first_seen_s, "
              "last_seen_s, views, zone, state, maybe_same_as, maybe_probability, digest) "
              "SELECT $1, n.number, coalesce((SELECT p.thing FROM objects p WHERE p.map = $3 AND p.number = n.number "
              "AND p.first_seen_s = n.first_seen_s), nextval('things')), true, n.class_id, n.probability, "
              "ST_MakePoint(n.x, n.y, n.z), ") +
              kBox +
              ", n.box_x_m, n.box_y_m, n.box_z_m, n.box_qx, n.box_qy, n.box_qz, n.box_qw, n.box_length_m, "
              "n.box_width_m, n.box_height_m, n.first_seen_s, n.last_seen_s, n.views, n.zone, n.state, "
              "n.maybe_same_as, n.maybe_probability, n.digest FROM json_to_recordset($2::json) AS n(number bigint, "
              "class_id smallint, probability float8, x float8, y float8, z float8, x0 float8, y0 float8, z0 float8, "
              "x1 float8, y1 float8, z1 float8, box_x_m float8, box_y_m float8, box_z_m float8, box_qx float8, "
              "box_qy float8, box_qz float8, box_qw float8, box_length_m float8, box_width_m float8, box_height_m "
              "float8, first_seen_s float8, last_seen_s float8, views integer, zone text, state text, maybe_same_as "
              "bigint, maybe_probability float8, digest text) ON CONFLICT (map, number) DO UPDATE SET "
              "(in_map, class_id, probability, place, box, box_x_m, box_y_m, box_z_m, box_qx, box_qy, box_qz, box_qw, "
              "box_length_m, box_width_m, box_height_m, first_seen_s, last_seen_s, views, zone, state, maybe_same_as, "
              "maybe_probability, digest) = (true, EXCLUDED.class_id, EXCLUDED.probability, EXCLUDED.place, "
              "EXCLUDED.box, EXCLUDED.box_x_m, EXCLUDED.box_y_m, EXCLUDED.box_z_m, EXCLUDED.box_qx, EXCLUDED.box_qy, "
              "EXCLUDED.box_qz, EXCLUDED.box_qw, EXCLUDED.box_length_m, EXCLUDED.box_width_m, EXCLUDED.box_height_m, "
              "EXCLUDED.first_seen_s, EXCLUDED.last_seen_s, EXCLUDED.views, EXCLUDED.zone, EXCLUDED.state, "
              "EXCLUDED.maybe_same_as, EXCLUDED.maybe_probability, EXCLUDED.digest)",
          map, parameterOf(changed), parent);
  return changed.size();
}

StayChanges findStays(pqxx::transaction_base& transaction, std::int64_t map, const MapSnapshot& snapshot) {
  const auto stored = readLastStays(transaction, map);
  const Corrections corrections(transaction, map, snapshot.map());
  StayChanges found;
  for (const auto& [number, object] : snapshot.map().objects) {
    const auto it = stored.find(number);
    const auto last = it == stored.end() ? std::optional<Stay>() : it->second;
    const bool mayHaveMoved = last && object.state != mapping::ObjectState::Static;
    const Eigen::Vector3d lastPlace_m = mayHaveMoved ? corrections.apply(last->place_m) : object.centroid_m;
    const auto update = updateStays(last, lastPlace_m, object, snapshot.tracesOf(number), snapshot.lastStamp_s());
    if (update.last && rowOf(number, *update.last) != rowOf(number, *last)) {
      found.last.push_back(rowOf(number, *update.last));
    }
    if (update.next) found.next.push_back(rowOf(number, *update.next));
    if (!update.change.empty()) found.changes.push_back(changeOf(object, last, update));
  }
  return found;
}

void writeStays(pqxx::transaction_base& transaction, std::int64_t map, const StayChanges& stays) {
  execute(transaction,
          std::string("UPDATE sightings AS s SET until_s = n.until_s, place = ST_MakePoint(n.x, n.y, n.z), box = ") +
              kBox + ", zone = n.zone, ended = n.ended, ended_s = n.ended_s FROM " + kRowsOfStays +
              " WHERE s.map = $1 AND s.object = n.object AND s.since_s = n.since_s",
          map, parameterOf(stays.last));
  execute(transaction,
          std::string("INSERT INTO sightings (map, object, since_s, until_s, place, box, zone, ended, ended_s) "
                      "SELECT $1, n.object, n.since_s, n.until_s, ST_MakePoint(n.x, n.y, n.z), ") +
              kBox + ", n.zone, n.ended, n.ended_s FROM " + kRowsOfStays,
          map, parameterOf(stays.next));
}

void writeChanges(pqxx::transaction_base& transaction, std::int64_t map, std::int64_t push,
                  const std::vector<Change>& changes) {
  Json rows = Json::array();
  for (const auto& change : changes) {
    rows.push_back({{"object", change.object},
                    {"kind", change.kind},
                    {"at_s", change.at_s},
                    {"x", change.place_m.x()},
                    {"y", change.place_m.y()},
                    {"z", change.place_m.z()},
                    {"zone", change.zone},
                    {"zone_before", change.zoneBefore}});
  }
  execute(transaction,
          "INSERT INTO changes (push, map, object, kind, at_s, place, zone, zone_before) "
          "SELECT $3, $1, n.object, n.kind, n.at_s, ST_MakePoint(n.x, n.y, n.z), n.zone, n.zone_before "
          "FROM json_to_recordset($2::json) AS n(object bigint, kind text, at_s float8, x float8, y float8, z float8, "
          "zone text, zone_before text)",
          map, parameterOf(rows), push);
}

}  // namespace wardslam::fleet
