#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <cmath>

#include "newest_stamp.h"
#include "polygons.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/blob.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/map_export.h"

namespace wardslam::exchange {
namespace {

using Line = std::vector<Eigen::Vector2d>;
using Extent = Eigen::AlignedBox2d;

constexpr std::int32_t kUndefinedCartesian = -1;
constexpr double kLongestGap_s = 10.0;  // between keyframes of one way

/// OGC 12-128r17 (GeoPackage 1.3), chapters 1 and 2.1: "GPKG", version 1.3.0, the tables each file must have, and the
/// reference systems it must know.
constexpr const char* kFrame = R"sql(
PRAGMA application_id = 0x47504B47;
PRAGMA user_version = 10300;
CREATE TABLE gpkg_spatial_ref_sys (
  srs_name TEXT NOT NULL, srs_id INTEGER PRIMARY KEY, organization TEXT NOT NULL,
  organization_coordsys_id INTEGER NOT NULL, definition TEXT NOT NULL, description TEXT);
CREATE TABLE gpkg_contents (
  table_name TEXT NOT NULL PRIMARY KEY, data_type TEXT NOT NULL, identifier TEXT UNIQUE, description TEXT DEFAULT '',
  last_change DATETIME NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ','now')),
  min_x DOUBLE, min_y DOUBLE, max_x DOUBLE, max_y DOUBLE, srs_id INTEGER,
  CONSTRAINT fk_gc_r_srs_id FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys(srs_id));
CREATE TABLE gpkg_geometry_columns (
  table_name TEXT NOT NULL, column_name TEXT NOT NULL, geometry_type_name TEXT NOT NULL, srs_id INTEGER NOT NULL,
  z TINYINT NOT NULL, m TINYINT NOT NULL,
  CONSTRAINT pk_geom_cols PRIMARY KEY (table_name, column_name),
  CONSTRAINT uk_gc_table_name UNIQUE (table_name),
  CONSTRAINT fk_gc_tn FOREIGN KEY (table_name) REFERENCES gpkg_contents(table_name),
  CONSTRAINT fk_gc_srs FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys (srs_id));
INSERT INTO gpkg_spatial_ref_sys VALUES
  ('Undefined Cartesian SRS', -1, 'NONE', -1, 'undefined', 'undefined Cartesian coordinate reference system'),
  ('Undefined geographic SRS', 0, 'NONE', 0, 'undefined', 'undefined geographic coordinate reference system'),
  ('WGS 84 geodetic', 4326, 'EPSG', 4326, 'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563,
AUTHORITY["EPSG","7030"]],AUTHORITY["EPSG","6326"]],PRIMEM["Greenwich",0,AUTHORITY["EPSG","8901"]],
UNIT["degree",0.0174532925199433,AUTHORITY["EPSG","9122"]],AXIS["Latitude",NORTH],AXIS["Longitude",EAST],
AUTHORITY["EPSG","4326"]]', 'longitude/latitude coordinates in decimal degrees on the WGS 84 spheroid');
CREATE TABLE zones (
  fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom POLYGON, name TEXT NOT NULL, type TEXT NOT NULL,
  max_speed_mps DOUBLE, direction_rad DOUBLE);
CREATE TABLE rooms (
  fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom POLYGON, name TEXT NOT NULL, area_m2 DOUBLE NOT NULL);
CREATE TABLE ways (
  fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom LINESTRING, first_s DOUBLE NOT NULL, last_s DOUBLE NOT NULL);
CREATE TABLE objects (
  fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom POLYGON, class_id INTEGER NOT NULL, class_name TEXT NOT NULL,
  probability DOUBLE NOT NULL, bottom_m DOUBLE NOT NULL, top_m DOUBLE NOT NULL, views INTEGER NOT NULL,
  zone TEXT NOT NULL, state TEXT NOT NULL);
)sql";

Extent extentOf(const Line& line) {
  Extent extent;
  for (const auto& corner : line) extent.extend(corner);
  return extent;
}

/// Chapter 2.1.3: the header of a geometry with its extent, then well-known binary. All little-endian, as ByteWriter
/// has it.
core::Bytes geometryOf(const Line& line, const std::vector<std::uint32_t>& wellKnown) {
  constexpr std::uint8_t kVersion = 0;
  constexpr std::uint8_t kLittleEndianWithExtent = 0x03;
  constexpr std::uint8_t kLittleEndian = 1;
  core::ByteWriter out;
  out.putBytes("GP", 2);
  out.put(kVersion);
  out.put(kLittleEndianWithExtent);
  out.put(kUndefinedCartesian);
  const Extent extent = extentOf(line);
  for (const double bound : {extent.min().x(), extent.max().x(), extent.min().y(), extent.max().y()}) out.put(bound);
  out.put(kLittleEndian);
  for (const std::uint32_t word : wellKnown) out.put(word);
  out.put(static_cast<std::uint32_t>(line.size()));
  for (const auto& corner : line) {
    out.put(corner.x());
    out.put(corner.y());
  }
  return out.bytes();
}

/// A polygon of one ring.
core::Bytes polygonOf(const Line& ring) { return geometryOf(ring, {3, 1}); }

core::Bytes lineStringOf(const Line& line) { return geometryOf(line, {2}); }

void bindGeometry(SQLite::Statement& insert, int column, const core::Bytes& geometry) {
  insert.bind(column, geometry.data(), static_cast<int>(geometry.size()));
}

Extent insertZones(SQLite::Database& database, const mapping::SemanticMap& map) {
  Extent extent;
  SQLite::Statement insert(database,
                           "INSERT INTO zones (geom, name, type, max_speed_mps, direction_rad) VALUES (?, ?, ?, ?, ?)");
  for (const auto& zone : map.zones) {
    const Line ring = closedRing(zone.polygon_m);
    extent.extend(extentOf(ring));
    insert.clearBindings();
    bindGeometry(insert, 1, polygonOf(ring));
    insert.bind(2, zone.name);
    insert.bind(3, mapping::toString(zone.type));
    if (zone.type == mapping::ZoneType::Slow) insert.bind(4, zone.maxSpeed_mps);
    if (zone.type == mapping::ZoneType::OneWay) insert.bind(5, zone.direction_rad);
    insert.exec();
    insert.reset();
  }
  return extent;
}

Extent insertObjects(SQLite::Database& database, const mapping::SemanticMap& map) {
  Extent extent;
  SQLite::Statement insert(database, "INSERT INTO objects VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const auto& [id, object] : map.objects) {
    if (object.state == mapping::ObjectState::Gone) continue;
    const Line ring = closedRing(footprintOf(object));
    extent.extend(extentOf(ring));
    insert.bind(1, static_cast<std::int64_t>(id));
    bindGeometry(insert, 2, polygonOf(ring));
    insert.bind(3, int{object.classId});
    insert.bind(4, map.labels.name(object.classId));
    insert.bind(5, object.probability);
    insert.bind(6, object.box_m.min().z());
    insert.bind(7, object.box_m.max().z());
    insert.bind(8, object.views);
    insert.bind(9, object.zone);
    insert.bind(10, toString(object.state));
    insert.exec();
    insert.reset();
  }
  return extent;
}

Extent insertRooms(SQLite::Database& database, const building::Rooms& rooms) {
  Extent extent;
  SQLite::Statement insert(database, "INSERT INTO rooms VALUES (?, ?, ?, ?)");
  for (const auto& room : rooms.all) {
    const Line ring = closedRing(room.outline_m);
    extent.extend(extentOf(ring));
    insert.bind(1, room.id);
    bindGeometry(insert, 2, polygonOf(ring));
    insert.bind(3, room.name);
    insert.bind(4, room.area_m2);
    insert.exec();
    insert.reset();
  }
  return extent;
}

/// A stretch of the map's keyframes without a gap.
struct DrivenWay {
  Line line;
  double first_s = 0.0;
  double last_s = 0.0;
};

std::vector<DrivenWay> drivenWays(const mapping::SemanticMap& map) {
  std::vector<DrivenWay> ways;
  for (const auto& [id, keyframe] : map.keyframes) {
    if (keyframe.piece != map.piece) continue;
    const bool goesOn = !ways.empty() && std::abs(keyframe.stamp_s - ways.back().last_s) < kLongestGap_s;
    if (!goesOn) ways.push_back({{}, keyframe.stamp_s, 0.0});
    ways.back().line.emplace_back(keyframe.T_map_cam.translation().head<2>());
    ways.back().last_s = keyframe.stamp_s;
  }
  const auto isPoint = [](const DrivenWay& way) { return way.line.size() < 2; };
  ways.erase(std::remove_if(ways.begin(), ways.end(), isPoint), ways.end());
  return ways;
}

Extent insertWays(SQLite::Database& database, const mapping::SemanticMap& map) {
  Extent extent;
  SQLite::Statement insert(database, "INSERT INTO ways (geom, first_s, last_s) VALUES (?, ?, ?)");
  for (const DrivenWay& way : drivenWays(map)) {
    extent.extend(extentOf(way.line));
    bindGeometry(insert, 1, lineStringOf(way.line));
    insert.bind(2, way.first_s);
    insert.bind(3, way.last_s);
    insert.exec();
    insert.reset();
  }
  return extent;
}

void registerLayer(SQLite::Database& database, const std::string& table, const char* geometryType, const Extent& extent,
                   const std::string& lastChange) {
  SQLite::Statement contents(
      database, "INSERT INTO gpkg_contents VALUES (?, 'features', ?, 'map frame, metres', ?, ?, ?, ?, ?, ?)");
  contents.bind(1, table);
  contents.bind(2, table);
  contents.bind(3, lastChange);
  if (!extent.isEmpty()) {  // else unknown
    contents.bind(4, extent.min().x());
    contents.bind(5, extent.min().y());
    contents.bind(6, extent.max().x());
    contents.bind(7, extent.max().y());
  }
  contents.bind(8, kUndefinedCartesian);
  contents.exec();
  SQLite::Statement geometry(database, "INSERT INTO gpkg_geometry_columns VALUES (?, 'geom', ?, ?, 0, 0)");
  geometry.bind(1, table);
  geometry.bind(2, geometryType);
  geometry.bind(3, kUndefinedCartesian);
  geometry.exec();
}

void writeTo(const std::filesystem::path& file, const mapping::SemanticMap& map, const building::Rooms& rooms) {
  std::filesystem::remove(file);  // what a run that was ended left
  SQLite::Database database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  SQLite::Transaction transaction(database);
  database.exec(kFrame);
  const std::string lastChange = newestStampOf(map);
  registerLayer(database, "zones", "POLYGON", insertZones(database, map), lastChange);
  registerLayer(database, "rooms", "POLYGON", insertRooms(database, rooms), lastChange);
  registerLayer(database, "objects", "POLYGON", insertObjects(database, map), lastChange);
  registerLayer(database, "ways", "LINESTRING", insertWays(database, map), lastChange);
  transaction.commit();
}

}  // namespace

void exportGeoPackage(const mapping::SemanticMap& map, const building::Rooms& rooms,
                      const std::filesystem::path& file) {
  core::replaceAtomically(file, [&](const std::filesystem::path& partial) {
    try {
      writeTo(partial, map, rooms);
    } catch (const SQLite::Exception& error) {
      throw core::InputError(partial.string() + ": cannot be written (" + error.what() +
                             "); is the folder there and writable?");
    }
  });
}

}  // namespace wardslam::exchange
