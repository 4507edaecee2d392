#include "map_schema.h"

#include <SQLiteCpp/Transaction.h>

#include <array>
#include <string>

namespace wardslam::storage {
namespace {

constexpr const char* kVersion1 = R"sql(
CREATE TABLE properties (name TEXT PRIMARY KEY, value NOT NULL) WITHOUT ROWID;
CREATE TABLE labels (class_id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE);

CREATE TABLE keyframes (
  id INTEGER PRIMARY KEY, stamp_s REAL NOT NULL,
  x_m REAL NOT NULL, y_m REAL NOT NULL, z_m REAL NOT NULL,
  qx REAL NOT NULL, qy REAL NOT NULL, qz REAL NOT NULL, qw REAL NOT NULL,
  zone TEXT NOT NULL);
CREATE TABLE free_fans (keyframe INTEGER PRIMARY KEY REFERENCES keyframes, points BLOB NOT NULL);
CREATE TABLE cameras (
  id INTEGER PRIMARY KEY, width_px INTEGER NOT NULL, height_px INTEGER NOT NULL,
  fx_px REAL NOT NULL, fy_px REAL NOT NULL, cx_px REAL NOT NULL, cy_px REAL NOT NULL,
  k1 REAL NOT NULL, k2 REAL NOT NULL, p1 REAL NOT NULL, p2 REAL NOT NULL, k3 REAL NOT NULL,
  UNIQUE (width_px, height_px, fx_px, fy_px, cx_px, cy_px, k1, k2, p1, p2, k3));
CREATE TABLE views (
  keyframe INTEGER PRIMARY KEY REFERENCES keyframes, stretch INTEGER NOT NULL,
  camera INTEGER NOT NULL REFERENCES cameras, features BLOB NOT NULL);
CREATE TABLE edges (
  kind TEXT NOT NULL CHECK (kind IN ('odometry', 'loop')),
  from_keyframe INTEGER NOT NULL REFERENCES keyframes, to_keyframe INTEGER NOT NULL REFERENCES keyframes,
  x_m REAL NOT NULL, y_m REAL NOT NULL, z_m REAL NOT NULL,
  qx REAL NOT NULL, qy REAL NOT NULL, qz REAL NOT NULL, qw REAL NOT NULL,
  PRIMARY KEY (kind, from_keyframe, to_keyframe)) WITHOUT ROWID;
CREATE TABLE points (id INTEGER PRIMARY KEY, x_m REAL NOT NULL, y_m REAL NOT NULL, z_m REAL NOT NULL);
CREATE TABLE sightings (
  keyframe INTEGER NOT NULL REFERENCES views, point INTEGER NOT NULL REFERENCES points, keypoint INTEGER NOT NULL,
  PRIMARY KEY (keyframe, point)) WITHOUT ROWID;
CREATE INDEX sightings_of_point ON sightings (point);

CREATE TABLE cloud_tiles (
  keyframe INTEGER PRIMARY KEY REFERENCES keyframes, point_count INTEGER NOT NULL, points BLOB NOT NULL);
CREATE TABLE objects (
  id INTEGER PRIMARY KEY, class_id INTEGER NOT NULL, probability REAL NOT NULL,
  centroid_x_m REAL NOT NULL, centroid_y_m REAL NOT NULL, centroid_z_m REAL NOT NULL,
  min_x_m REAL NOT NULL, min_y_m REAL NOT NULL, min_z_m REAL NOT NULL,
  max_x_m REAL NOT NULL, max_y_m REAL NOT NULL, max_z_m REAL NOT NULL,
  box_x_m REAL NOT NULL, box_y_m REAL NOT NULL, box_z_m REAL NOT NULL,
  box_qx REAL NOT NULL, box_qy REAL NOT NULL, box_qz REAL NOT NULL, box_qw REAL NOT NULL,
  box_length_m REAL NOT NULL, box_width_m REAL NOT NULL, box_height_m REAL NOT NULL,
  red INTEGER NOT NULL, green INTEGER NOT NULL, blue INTEGER NOT NULL,
  first_seen_s REAL NOT NULL, last_seen_s REAL NOT NULL, views INTEGER NOT NULL,
  zone TEXT NOT NULL, state TEXT NOT NULL CHECK (state IN ('static', 'moved', 'gone')));
CREATE INDEX objects_of_class ON objects (class_id);
CREATE VIRTUAL TABLE object_boxes USING rtree(id, min_x_m, max_x_m, min_y_m, max_y_m, min_z_m, max_z_m);

CREATE TABLE zones (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE);
CREATE TABLE zone_corners (
  zone INTEGER NOT NULL REFERENCES zones, position INTEGER NOT NULL, x_m REAL NOT NULL, y_m REAL NOT NULL,
  PRIMARY KEY (zone, position)) WITHOUT ROWID;
CREATE TABLE floor_plan (
  id INTEGER PRIMARY KEY CHECK (id = 1), resolution_m REAL NOT NULL,
  origin_x_m REAL NOT NULL, origin_y_m REAL NOT NULL, cells BLOB NOT NULL);
)sql";

/// What a run that goes on must know besides what the map shows; and pieces. What was stored before was one piece.
constexpr const char* kVersion2 = R"sql(
ALTER TABLE edges ADD COLUMN inliers INTEGER NOT NULL DEFAULT 30;
CREATE TABLE depth_noises (
  keyframe INTEGER PRIMARY KEY REFERENCES views,
  least_m REAL NOT NULL, growth_per_m REAL NOT NULL, from_m REAL NOT NULL);
CREATE TABLE object_hints (
  object INTEGER PRIMARY KEY, maybe_same_as INTEGER NOT NULL, probability REAL NOT NULL);
CREATE TABLE tile_memories (keyframe INTEGER PRIMARY KEY REFERENCES keyframes, points BLOB NOT NULL);
CREATE TABLE object_memories (
  object INTEGER PRIMARY KEY, views INTEGER NOT NULL, expected INTEGER NOT NULL, missed INTEGER NOT NULL,
  first_seen_s REAL NOT NULL, last_seen_s REAL NOT NULL,
  last_x_m REAL NOT NULL, last_y_m REAL NOT NULL, last_z_m REAL NOT NULL,
  handled_s REAL NOT NULL, views_to_rest INTEGER NOT NULL, erased INTEGER NOT NULL, gone_s REAL NOT NULL,
  place_was_empty INTEGER NOT NULL, state TEXT NOT NULL CHECK (state IN ('static', 'moved', 'gone')),
  piece INTEGER NOT NULL);
CREATE TABLE object_votes (
  object INTEGER NOT NULL, class_id INTEGER NOT NULL, confidence REAL NOT NULL,
  PRIMARY KEY (object, class_id)) WITHOUT ROWID;
CREATE TABLE object_pairs (
  object INTEGER NOT NULL, other INTEGER NOT NULL, together INTEGER NOT NULL, apart INTEGER NOT NULL,
  PRIMARY KEY (object, other)) WITHOUT ROWID;
ALTER TABLE keyframes ADD COLUMN piece INTEGER NOT NULL DEFAULT 0;
ALTER TABLE objects ADD COLUMN piece INTEGER NOT NULL DEFAULT 0;
CREATE VIEW map_piece AS SELECT coalesce(
  (SELECT CAST(value AS INTEGER) FROM properties WHERE name = 'map_piece'),
  (SELECT piece FROM keyframes GROUP BY piece ORDER BY count(*) DESC, piece LIMIT 1), 0) AS piece;
)sql";

/// The ground under keyframes. Of older ones it is not known: their images are not kept.
constexpr const char* kVersion3 = R"sql(
CREATE TABLE grounds (
  keyframe INTEGER PRIMARY KEY REFERENCES keyframes,
  normal_x REAL NOT NULL, normal_y REAL NOT NULL, normal_z REAL NOT NULL, height_m REAL NOT NULL,
  variance_1 REAL NOT NULL, variance_2 REAL NOT NULL, variance_height_m2 REAL NOT NULL,
  covariance_12 REAL NOT NULL, covariance_1_height_m REAL NOT NULL, covariance_2_height_m REAL NOT NULL);
)sql";

/// What keyframes saw of surfaces: tells places that look the same apart. Of older ones it is not known.
constexpr const char* kVersion4 = R"sql(
CREATE TABLE depth_views (keyframe INTEGER PRIMARY KEY REFERENCES views, cells BLOB NOT NULL);
)sql";

/// What zones ask of robots. Older ones were names of places.
constexpr const char* kVersion5 = R"sql(
ALTER TABLE zones ADD COLUMN type TEXT NOT NULL DEFAULT 'place'
  CHECK (type IN ('place', 'forbidden', 'slow', 'one_way', 'action', 'release'));
ALTER TABLE zones ADD COLUMN max_speed_mps REAL NOT NULL DEFAULT 0;
ALTER TABLE zones ADD COLUMN direction_rad REAL NOT NULL DEFAULT 0;
CREATE TABLE zone_actions (
  zone INTEGER NOT NULL REFERENCES zones, moment TEXT NOT NULL CHECK (moment IN ('entry', 'inside', 'exit')),
  position INTEGER NOT NULL, action TEXT NOT NULL, PRIMARY KEY (zone, moment, position)) WITHOUT ROWID;
)sql";

/// The step at [i] leads from version i to i + 1.
constexpr std::array<const char*, 5> kSteps = {kVersion1, kVersion2, kVersion3, kVersion4, kVersion5};

}  // namespace

int schemaVersion() { return static_cast<int>(kSteps.size()); }

void migrateSchema(SQLite::Database& database) {
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  for (int version = database.execAndGet("PRAGMA user_version"); version < schemaVersion(); ++version) {
    database.exec(kSteps.at(static_cast<std::size_t>(version)));
    database.exec("PRAGMA user_version = " + std::to_string(version + 1));
  }
  database.exec("PRAGMA application_id = " + std::to_string(kApplicationId));
  transaction.commit();
}

}  // namespace wardslam::storage
