#include "map_reading.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <functional>

#include "blob_codecs.h"
#include "map_rows.h"

namespace wardslam::storage {
namespace {

// What any camera and any floor plan has room in.
constexpr int kWidest_px = 20000;
constexpr double kLongestFocus_px = 1e6;
constexpr double kStrongestLens = 1e4;
constexpr double kFinestPlan_m = 1e-3;
constexpr double kCoarsestPlan_m = 100.0;

/// Hands every row to `take`; trouble with a row is told with `what` it is and its first column.
template <class Take>
void forEachRow(SQLite::Database& database, const std::string& what, const char* sql, const Take& take) {
  SQLite::Statement statement(database, sql);
  while (statement.executeStep()) {
    try {
      take(ColumnReader(statement));
    } catch (const core::BlobError& error) {
      throw core::BlobError(what + " " + statement.getColumn(0).getString() + ": " + error.what());
    }
  }
}

std::size_t count(SQLite::Database& database, const char* sql) {
  return static_cast<std::size_t>(database.execAndGet(sql).getInt64());
}

void readKeyframes(SQLite::Database& database, mapping::SemanticMap& map) {
  forEachRow(database, "keyframe", "SELECT id, stamp_s, x_m, y_m, z_m, qx, qy, qz, qw, zone FROM keyframes ORDER BY id",
             [&map](ColumnReader row) {
               odometry::KeyframeId id = 0;
               mapping::MappedKeyframe keyframe;
               row >> id >> within(keyframe.stamp_s, 0.0, kLatest_s) >> keyframe.T_map_cam >> keyframe.zone;
               map.keyframes.emplace(id, keyframe);
             });
}

void readFreeFans(SQLite::Database& database, mapping::SemanticMap& map) {
  forEachRow(database, "free fan of keyframe", "SELECT keyframe, points FROM free_fans", [&map](ColumnReader row) {
    odometry::KeyframeId keyframe = 0;
    core::Bytes blob;
    row >> keyframe >> blob;
    const auto found = map.keyframes.find(keyframe);
    if (found == map.keyframes.end()) throw core::BlobError("that keyframe is missing");
    found->second.freeFan_cam_m = decodeFan(blob);
  });
}

void readCloud(SQLite::Database& database, mapping::SemanticMap& map) {
  forEachRow(database, "cloud tile of keyframe", "SELECT keyframe, points FROM cloud_tiles ORDER BY keyframe",
             [&map](ColumnReader row) {
               odometry::KeyframeId keyframe = 0;
               core::Bytes blob;
               row >> keyframe >> blob;
               map.cloud.emplace(keyframe, decodeTile(blob));
             });
}

mapping::MapObject objectOf(ColumnReader row) {
  mapping::MapObject object;
  std::string state;
  auto& [red, green, blue] = object.color_rgb;
  row >> object.id >> object.classId >> within(object.probability, 0.0, 1.0) >> object.centroid_m >>
      object.box_m.min() >> object.box_m.max() >> object.orientedBox.T_map_box >> object.orientedBox.size_m >> red >>
      green >> blue >> within(object.firstSeen_s, 0.0, kLatest_s) >> within(object.lastSeen_s, 0.0, kLatest_s) >>
      object.views >> object.zone >> state;
  if ((object.box_m.min().array() > object.box_m.max().array()).any()) throw core::BlobError("its box is inside out");
  if ((object.orientedBox.size_m.array() < 0).any()) throw core::BlobError("its box has a negative size");
  object.state = objectState(state);
  return object;
}

void readObjects(SQLite::Database& database, mapping::SemanticMap& map) {
  forEachRow(database, "object",
             "SELECT id, class_id, probability, centroid_x_m, centroid_y_m, centroid_z_m, min_x_m, min_y_m, min_z_m, "
             "max_x_m, max_y_m, max_z_m, box_x_m, box_y_m, box_z_m, box_qx, box_qy, box_qz, box_qw, box_length_m, "
             "box_width_m, box_height_m, red, green, blue, first_seen_s, last_seen_s, views, zone, state "
             "FROM objects ORDER BY id",
             [&map](ColumnReader row) {
               const auto object = objectOf(row);
               map.objects.emplace(object.id, object);
             });
}

void readZones(SQLite::Database& database, mapping::SemanticMap& map) {
  std::map<std::uint32_t, mapping::Zone> zones;
  forEachRow(database, "zone", "SELECT id, name FROM zones ORDER BY id", [&zones](ColumnReader row) {
    std::uint32_t id = 0;
    std::string name;
    row >> id >> name;
    zones[id].name = name;
  });
  forEachRow(database, "zone", "SELECT zone, x_m, y_m FROM zone_corners ORDER BY zone, position",
             [&zones](ColumnReader row) {
               std::uint32_t id = 0;
               Eigen::Vector2d corner_m;
               row >> id >> corner_m;
               zones[id].polygon_m.push_back(corner_m);
             });
  for (auto& [id, zone] : zones) map.zones.push_back(std::move(zone));
}

void readFloorPlan(SQLite::Database& database, mapping::SemanticMap& map) {
  forEachRow(database, "floor plan", "SELECT id, resolution_m, origin_x_m, origin_y_m, cells FROM floor_plan",
             [&map](ColumnReader row) {
               std::uint32_t id = 0;
               core::Bytes blob;
               row >> id >> within(map.floorPlan.resolution_m, kFinestPlan_m, kCoarsestPlan_m);
               row >> map.floorPlan.origin_m >> blob;
               map.floorPlan.cells = decodeCells(blob);
             });
}

std::map<std::uint32_t, core::CameraModel> readCameras(SQLite::Database& database) {
  std::map<std::uint32_t, core::CameraModel> cameras;
  forEachRow(database, "camera",
             "SELECT id, width_px, height_px, fx_px, fy_px, cx_px, cy_px, k1, k2, p1, p2, k3 FROM cameras",
             [&cameras](ColumnReader row) {
               std::uint32_t id = 0;
               core::CameraModel c;
               row >> id >> within(c.width_px, 1, kWidest_px) >> within(c.height_px, 1, kWidest_px);
               for (double* focus_px : {&c.fx_px, &c.fy_px}) row >> within(*focus_px, 1.0, kLongestFocus_px);
               for (double* centre_px : {&c.cx_px, &c.cy_px}) {
                 row >> within(*centre_px, -kLongestFocus_px, kLongestFocus_px);
               }
               for (double* k : {&c.k1, &c.k2, &c.p1, &c.p2, &c.k3}) row >> within(*k, -kStrongestLens, kStrongestLens);
               cameras.emplace(id, c);
             });
  return cameras;
}

std::map<odometry::KeyframeId, odometry::Keyframe> readKeyframesWithFeatures(SQLite::Database& database) {
  const auto cameras = readCameras(database);
  std::map<odometry::KeyframeId, odometry::Keyframe> views;
  forEachRow(database, "features of keyframe",
             "SELECT id, stamp_s, x_m, y_m, z_m, qx, qy, qz, qw, camera, features "
             "FROM keyframes JOIN views ON keyframe = id",
             [&](ColumnReader row) {
               odometry::Keyframe view;
               std::uint32_t camera = 0;
               core::Bytes blob;
               row >> view.id >> within(view.stamp_s, 0.0, kLatest_s) >> view.T_map_cam >> camera >> blob;
               if (cameras.count(camera) == 0) throw core::BlobError("its camera is missing");
               view.camera = cameras.at(camera);
               view.features = decodeFeatures(blob);
               views.emplace(view.id, std::move(view));
             });
  return views;
}

std::vector<LoopEdge> readEdges(SQLite::Database& database, const std::string& kind) {
  std::vector<LoopEdge> edges;
  const std::string sql = "SELECT from_keyframe, to_keyframe, x_m, y_m, z_m, qx, qy, qz, qw FROM edges WHERE kind = '" +
                          kind + "' ORDER BY to_keyframe, from_keyframe";
  forEachRow(database, kind + " edge from keyframe", sql.c_str(), [&edges](ColumnReader row) {
    LoopEdge edge;
    row >> edge.from >> edge.to >> edge.T_from_to;
    edges.push_back(edge);
  });
  return edges;
}

}  // namespace

MapFileInfo readInfo(SQLite::Database& database) {
  MapFileInfo info;
  info.schemaVersion = database.execAndGet("PRAGMA user_version");
  info.keyframes = count(database, "SELECT count(*) FROM keyframes");
  info.trackingPoints = count(database, "SELECT count(*) FROM points");
  info.loops = count(database, "SELECT count(*) FROM edges WHERE kind = 'loop'");
  info.cloudPoints = count(database, "SELECT coalesce(sum(point_count), 0) FROM cloud_tiles");
  info.objects = count(database, "SELECT count(*) FROM objects");
  info.zones = count(database, "SELECT count(*) FROM zones");
  info.firstStamp_s = database.execAndGet("SELECT coalesce(min(stamp_s), 0) FROM keyframes");
  info.lastStamp_s = database.execAndGet("SELECT coalesce(max(stamp_s), 0) FROM keyframes");
  return info;
}

MapHeader readHeader(SQLite::Database& database) {
  MapHeader header;
  forEachRow(database, "property", "SELECT name, value FROM properties WHERE name = 'options'",
             [&header](ColumnReader row) {
               std::string name;
               row >> name >> header.options;
             });
  forEachRow(database, "label", "SELECT class_id, name FROM labels ORDER BY class_id", [&header](ColumnReader row) {
    core::ClassId id = 0;
    std::string name;
    row >> id >> name;
    header.labels.rename(id, name);
  });
  return header;
}

mapping::SemanticMap readMap(SQLite::Database& database, CloudPart cloud) {
  mapping::SemanticMap map;
  map.labels = readHeader(database).labels;
  readKeyframes(database, map);
  readFreeFans(database, map);
  if (cloud == CloudPart::Include) readCloud(database, map);
  readObjects(database, map);
  readZones(database, map);
  readFloorPlan(database, map);
  return map;
}

std::vector<odometry::Keyframe> readViews(SQLite::Database& database) {
  auto views = readKeyframesWithFeatures(database);
  for (const auto& edge : readEdges(database, "odometry")) {
    if (const auto view = views.find(edge.to); view != views.end()) view->second.T_previous_cam = edge.T_from_to;
  }
  forEachRow(database, "sighting of keyframe",
             "SELECT keyframe, point, keypoint FROM sightings ORDER BY keyframe, point", [&views](ColumnReader row) {
               odometry::KeyframeId keyframe = 0;
               odometry::PointId point = 0;
               std::uint64_t keypoint = 0;
               row >> keyframe >> point >> keypoint;
               const auto view = views.find(keyframe);
               if (view == views.end()) throw core::BlobError("that keyframe has no features");
               if (keypoint >= view->second.features.size())
                 throw core::BlobError("it names a key point that is not there");
               view->second.sightings.push_back({point, static_cast<std::size_t>(keypoint)});
             });
  std::vector<odometry::Keyframe> inOrder;
  inOrder.reserve(views.size());
  for (auto& [id, view] : views) inOrder.push_back(std::move(view));
  return inOrder;
}

std::map<odometry::PointId, Eigen::Vector3d> readPoints(SQLite::Database& database) {
  std::map<odometry::PointId, Eigen::Vector3d> points;
  forEachRow(database, "point", "SELECT id, x_m, y_m, z_m FROM points ORDER BY id", [&points](ColumnReader row) {
    odometry::PointId id = 0;
    Eigen::Vector3d p_map_m;
    row >> id >> p_map_m;
    points.emplace(id, p_map_m);
  });
  return points;
}

std::vector<LoopEdge> readLoops(SQLite::Database& database) { return readEdges(database, "loop"); }

}  // namespace wardslam::storage
