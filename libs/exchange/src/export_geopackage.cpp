#include <SQLiteCpp/SQLiteCpp.h>

#include <cmath>
#include <ctime>

#include "polygons.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/blob.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/map_export.h"

namespace wardslam::exchange {
namespace {

using Ring = std::vector<Eigen::Vector2d>;
using Extent = Eigen::AlignedBox2d;

constexpr std::int32_t kUndefinedCartesian = -1;

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
CREATE TABLE zones (fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom POLYGON, name TEXT NOT NULL);
CREATE TABLE objects (
  fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom POLYGON, class_id INTEGER NOT NULL, class_name TEXT NOT NULL,
  probability DOUBLE NOT NULL, bottom_m DOUBLE NOT NULL, top_m DOUBLE NOT NULL, views INTEGER NOT NULL,
  zone TEXT NOT NULL, state TEXT NOT NULL);
)sql";

Extent extentOf(const Ring& ring) {
  Extent extent;
  for (const auto& corner : ring) extent.extend(corner);
  return extent;
}

/// Chapter 2.1.3: the header of a geometry with its extent, then a polygon of one ring as well-known binary. All
/// little-endian, as ByteWriter has it.
core::Bytes geometryOf(const Ring& ring) {
  constexpr std::uint8_t kVersion = 0;
  constexpr std::uint8_t kLittleEndianWithExtent = 0x03;
  constexpr std::uint8_t kLittleEndian = 1;
  constexpr std::uint32_t kPolygon = 3;
  core::ByteWriter out;
  out.putBytes("GP", 2);
  out.put(kVersion);
  out.put(kLittleEndianWithExtent);
  out.put(kUndefinedCartesian);
  const Extent extent = extentOf(ring);
  for (const double bound : {extent.min().x(), extent.max().x(), extent.min().y(), extent.max().y()}) out.put(bound);
  out.put(kLittleEndian);
  out.put(kPolygon);
  out.put(std::uint32_t{1});
  out.put(static_cast<std::uint32_t>(ring.size()));
  for (const auto& corner : ring) {
    out.put(corner.x());
    out.put(corner.y());
  }
  return out.bytes();
}

void bindGeometry(SQLite::Statement& insert, int column, const Ring& ring) {
  const core::Bytes geometry = geometryOf(ring);
  insert.bind(column, geometry.data(), static_cast<int>(geometry.size()));
}

Extent insertZones(SQLite::Database& database, const mapping::SemanticMap& map) {
  Extent extent;
  SQLite::Statement insert(database, "INSERT INTO zones (geom, name) VALUES (?, ?)");
  for (const auto& zone : map.zones) {
    const Ring ring = closedRing(zone.polygon_m);
    extent.extend(extentOf(ring));
    bindGeometry(insert, 1, ring);
    insert.bind(2, zone.name);
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
    const Ring ring = closedRing(footprintOf(object));
    extent.extend(extentOf(ring));
    insert.bind(1, static_cast<std::int64_t>(id));
    bindGeometry(insert, 2, ring);
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

/// When the map saw its last keyframe, as the standard wants times; so the same map makes the same file.
std::string lastChangeOf(const mapping::SemanticMap& map) {
  double newest_s = 0.0;
  for (const auto& [id, keyframe] : map.keyframes) newest_s = std::max(newest_s, keyframe.stamp_s);
  const auto seconds = static_cast<std::time_t>(newest_s);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S.000Z", &utc);
  return text;
}

void registerLayer(SQLite::Database& database, const std::string& table, const Extent& extent,
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
  SQLite::Statement geometry(database, "INSERT INTO gpkg_geometry_columns VALUES (?, 'geom', 'POLYGON', ?, 0, 0)");
  geometry.bind(1, table);
  geometry.bind(2, kUndefinedCartesian);
  geometry.exec();
}

void writeTo(const std::filesystem::path& file, const mapping::SemanticMap& map) {
  std::filesystem::remove(file);  // what a run that was ended left
  SQLite::Database database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  SQLite::Transaction transaction(database);
  database.exec(kFrame);
  const std::string lastChange = lastChangeOf(map);
  registerLayer(database, "zones", insertZones(database, map), lastChange);
  registerLayer(database, "objects", insertObjects(database, map), lastChange);
  transaction.commit();
}

}  // namespace

void exportGeoPackage(const mapping::SemanticMap& map, const std::filesystem::path& file) {
  core::replaceAtomically(file, [&map](const std::filesystem::path& partial) {
    try {
      writeTo(partial, map);
    } catch (const SQLite::Exception& error) {
      throw core::InputError(partial.string() + ": cannot be written (" + error.what() +
                             "); is the folder there and writable?");
    }
  });
}

}  // namespace wardslam::exchange
