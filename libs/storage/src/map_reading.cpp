#include "map_reading.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "blob_codecs.h"
#include "map_rows.h"
#include "wardslam/core/camera_limits.h"
#include "zone_rows.h"

namespace wardslam::storage {
namespace {

// What any camera and any floor plan has room in.
constexpr int kWidest_px = 20000;
constexpr double kFinestPlan_m = 1e-3;
constexpr double kCoarsestPlan_m = 100.0;
constexpr double kFarthestGround_m = 1e4;

std::size_t count(SQLite::Database& database, const char* sql) {
  return static_cast<std::size_t>(database.execAndGet(sql).getInt64());
}

std::uint32_t mapPieceOf(SQLite::Database& database) {
  std::uint32_t number = 0;
  forEachRow(database, "the map's", "SELECT 'piece', piece FROM map_piece", [&number](ColumnReader row) {
    std::string name;
    row >> name >> pieceIn(number);
  });
  return number;
}

void readKeyframes(SQLite::Database& database, mapping::SemanticMap& map) {
  forEachRow(
      database, "keyframe", "SELECT id, stamp_s, x_m, y_m, z_m, qx, qy, qz, qw, zone, piece FROM keyframes ORDER BY id",
      [&map](ColumnReader row) {
        odometry::KeyframeId id = 0;
        mapping::MappedKeyframe keyframe;
        row >> idIn(id) >> stampIn(keyframe.stamp_s) >> keyframe.T_map_cam >> keyframe.zone >> pieceIn(keyframe.piece);
        map.keyframes.emplace(id, keyframe);
      });
}

/// Only after everything is read: what is missing counts as damage.
void keepOnlyTheMap(mapping::SemanticMap& map) {
  for (auto it = map.keyframes.begin(); it != map.keyframes.end();) {
    if (it->second.piece == map.piece) {
      ++it;
      continue;
    }
    map.cloud.erase(it->first);
    it = map.keyframes.erase(it);
  }
  for (auto it = map.objects.begin(); it != map.objects.end();) {
    it = it->second.piece == map.piece ? std::next(it) : map.objects.erase(it);
  }
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

/// No correlation is more than whole.
bool isCovariance(const Eigen::Matrix3d& c) {
  constexpr double kRounding = 1.0 + 1e-9;
  const auto isPossible = [&c](int i, int j) { return c(i, j) * c(i, j) <= kRounding * c(i, i) * c(j, j); };
  return isPossible(0, 1) && isPossible(0, 2) && isPossible(1, 2);
}

void readGrounds(SQLite::Database& database, mapping::SemanticMap& map) {
  forEachRow(database, "ground of keyframe",
             "SELECT keyframe, normal_x, normal_y, normal_z, height_m, variance_1, variance_2, variance_height_m2, "
             "covariance_12, covariance_1_height_m, covariance_2_height_m FROM grounds",
             [&map](ColumnReader row) {
               odometry::KeyframeId keyframe = 0;
               core::GroundPlane ground;
               Eigen::Matrix3d& c = ground.covariance;
               row >> keyframe >> ground.normal_cam >> within(ground.height_m, -kFarthestGround_m, kFarthestGround_m);
               for (const int i : {0, 1, 2}) row >> within(c(i, i), 0.0, kFarthestGround_m);
               for (const auto& [i, j] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
                 row >> within(c(i, j), -kFarthestGround_m, kFarthestGround_m);
                 c(j, i) = c(i, j);
               }
               if (!isCovariance(c)) throw core::BlobError("its covariance is impossible");
               if (std::abs(ground.normal_cam.norm() - 1.0) > 1e-6)
                 throw core::BlobError("its normal has no direction");
               const auto found = map.keyframes.find(keyframe);
               if (found == map.keyframes.end()) throw core::BlobError("that keyframe is missing");
               found->second.ground = ground;
             });
}

void readCloud(SQLite::Database& database, mapping::SemanticMap& map) {
  forEachRow(database, "cloud tile of keyframe",
             "SELECT keyframe, point_count, points FROM cloud_tiles ORDER BY keyframe", [&map](ColumnReader row) {
               odometry::KeyframeId keyframe = 0;
               std::uint64_t count = 0;
               core::Bytes blob;
               row >> keyframe >> count >> blob;
               if (map.keyframes.count(keyframe) == 0) throw core::BlobError("that keyframe is missing");
               const auto& tile = map.cloud.emplace(keyframe, decodeTile(blob)).first->second;
               if (tile.points.size() != count) throw core::BlobError("its point_count is not that of its points");
             });
}

mapping::MapObject objectOf(ColumnReader row) {
  mapping::MapObject object;
  std::string state;
  auto& [red, green, blue] = object.color_rgb;
  row >> idIn(object.id) >> object.classId >> within(object.probability, 0.0, 1.0) >> object.centroid_m >>
      object.box_m.min() >> object.box_m.max() >> object.orientedBox.T_map_box >> object.orientedBox.size_m >> red >>
      green >> blue >> stampIn(object.firstSeen_s) >> stampIn(object.lastSeen_s) >> countIn(object.views) >>
      object.zone >> state >> pieceIn(object.piece);
  if ((object.box_m.min().array() > object.box_m.max().array()).any()) throw core::BlobError("its box is inside out");
  if ((object.orientedBox.size_m.array() < 0).any()) throw core::BlobError("its box has a negative size");
  object.state = objectState(state);
  return object;
}

void readObjects(SQLite::Database& database, mapping::SemanticMap& map) {
  forEachRow(database, "object",
             "SELECT id, class_id, probability, centroid_x_m, centroid_y_m, centroid_z_m, min_x_m, min_y_m, min_z_m, "
             "max_x_m, max_y_m, max_z_m, box_x_m, box_y_m, box_z_m, box_qx, box_qy, box_qz, box_qw, box_length_m, "
             "box_width_m, box_height_m, red, green, blue, first_seen_s, last_seen_s, views, zone, state, piece "
             "FROM objects ORDER BY id",
             [&map](ColumnReader row) {
               const auto object = objectOf(row);
               map.objects.emplace(object.id, object);
             });
}

void readHints(SQLite::Database& database, mapping::SemanticMap& map) {
  forEachRow(database, "hint about object", "SELECT object, maybe_same_as, probability FROM object_hints",
             [&map](ColumnReader row) {
               mapping::ObjectId object = 0;
               mapping::MaybeSame hint;
               row >> object >> idIn(hint.id) >> within(hint.probability, 0.0, 1.0);
               const auto found = map.objects.find(object);
               if (found == map.objects.end()) throw core::BlobError("that object is missing");
               found->second.maybeSameAs = hint;
             });
}

void requirePossibleCells(const cv::Mat& cells) {
  using mapping::FloorPlan;
  for (int y = 0; y < cells.rows; ++y) {
    const auto* row = cells.ptr<std::uint8_t>(y);
    const bool arePossible = std::all_of(row, row + cells.cols, [](std::uint8_t cell) {
      return cell == FloorPlan::kFree || cell == FloorPlan::kOccupied || cell == FloorPlan::kUnknown;
    });
    if (!arePossible) throw core::BlobError("it has a cell that is neither free nor occupied nor unknown");
  }
}

void readFloorPlan(SQLite::Database& database, mapping::SemanticMap& map) {
  forEachRow(database, "floor plan", "SELECT id, resolution_m, origin_x_m, origin_y_m, cells FROM floor_plan",
             [&map](ColumnReader row) {
               std::uint32_t id = 0;
               core::Bytes blob;
               row >> id >> within(map.floorPlan.resolution_m, kFinestPlan_m, kCoarsestPlan_m);
               row >> map.floorPlan.origin_m >> blob;
               map.floorPlan.cells = decodeCells(blob);
               requirePossibleCells(map.floorPlan.cells);
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
               for (double* focus_px : {&c.fx_px, &c.fy_px}) row >> within(*focus_px, 1.0, core::kLongestFocus_px);
               for (double* centre_px : {&c.cx_px, &c.cy_px}) {
                 row >> within(*centre_px, -core::kLongestFocus_px, core::kLongestFocus_px);
               }
               for (double* k : {&c.k1, &c.k2, &c.p1, &c.p2, &c.k3})
                 row >> within(*k, -core::kStrongestLens, core::kStrongestLens);
               cameras.emplace(id, c);
             });
  return cameras;
}

/// A Kinect's where the map says nothing.
void readDepthNoises(SQLite::Database& database, std::map<odometry::KeyframeId, odometry::Keyframe>& views) {
  forEachRow(database, "depth noise of keyframe", "SELECT keyframe, least_m, growth_per_m, from_m FROM depth_noises",
             [&views](ColumnReader row) {
               odometry::KeyframeId keyframe = 0;
               core::DepthNoise noise;
               row >> keyframe >> within(noise.least_m, 1e-6, 10.0) >> within(noise.growth_per_m, 0.0, 10.0) >>
                   within(noise.from_m, 0.0, 100.0);
               const auto view = views.find(keyframe);
               if (view == views.end()) throw core::BlobError("that keyframe has no features");
               view->second.camera.depthNoise = noise;
             });
}

void readDepthViews(SQLite::Database& database, std::map<odometry::KeyframeId, odometry::Keyframe>& views) {
  forEachRow(database, "depth view of keyframe", "SELECT keyframe, cells FROM depth_views", [&views](ColumnReader row) {
    odometry::KeyframeId keyframe = 0;
    core::Bytes blob;
    row >> keyframe >> blob;
    const auto view = views.find(keyframe);
    if (view == views.end()) throw core::BlobError("that keyframe has no features");
    view->second.depth = std::make_shared<odometry::DepthView>(decodeDepthView(blob));
  });
}

std::map<odometry::KeyframeId, odometry::Keyframe> readKeyframesWithFeatures(SQLite::Database& database) {
  const auto cameras = readCameras(database);
  std::map<odometry::KeyframeId, odometry::Keyframe> views;
  forEachRow(database, "features of keyframe",
             "SELECT id, stamp_s, x_m, y_m, z_m, qx, qy, qz, qw, piece, camera, features "
             "FROM keyframes JOIN views ON keyframe = id",
             [&](ColumnReader row) {
               odometry::Keyframe view;
               std::uint32_t camera = 0;
               core::Bytes blob;
               row >> idIn(view.id) >> stampIn(view.stamp_s) >> view.T_map_cam >> pieceIn(view.submap) >> camera >>
                   blob;
               if (cameras.count(camera) == 0) throw core::BlobError("its camera is missing");
               view.camera = cameras.at(camera);
               view.features = decodeFeatures(blob);
               views.emplace(view.id, std::move(view));
             });
  readDepthNoises(database, views);
  readDepthViews(database, views);
  return views;
}

std::vector<LoopEdge> readEdges(SQLite::Database& database, const std::string& kind) {
  std::vector<LoopEdge> edges;
  const std::string sql =
      "SELECT from_keyframe, to_keyframe, edges.x_m, edges.y_m, edges.z_m, edges.qx, edges.qy, edges.qz, edges.qw, "
      "inliers, a.id IS NOT NULL AND b.id IS NOT NULL FROM edges LEFT JOIN keyframes a ON a.id = from_keyframe "
      "LEFT JOIN keyframes b ON b.id = to_keyframe WHERE kind = '" +
      kind + "' ORDER BY to_keyframe, from_keyframe";
  forEachRow(database, kind + " edge from keyframe", sql.c_str(), [&edges](ColumnReader row) {
    LoopEdge edge;
    int isTied = 0;
    row >> edge.from >> edge.to >> edge.T_from_to >> countIn(edge.inliers) >> isTied;
    if (isTied == 0 || edge.from == edge.to) throw core::BlobError("it does not tie two keyframes of the map");
    edges.push_back(edge);
  });
  return edges;
}

mapping::ObjectId nextObjectId(SQLite::Database& database) {
  mapping::ObjectId next = 1;
  forEachRow(database, "property", "SELECT 'next_object_id', value FROM properties WHERE name = 'next_object_id'",
             [&next](ColumnReader row) {
               std::string name;
               row >> name >> idIn(next);
             });
  return next;
}

/// The map first.
std::vector<PieceInfo> readParts(SQLite::Database& database) {
  std::vector<PieceInfo> pieces;
  forEachRow(
      database, "piece",
      "SELECT keyframes.piece, keyframes.piece = map_piece.piece AS is_map, count(*), min(stamp_s), "
      "max(stamp_s), coalesce(value, '') FROM keyframes JOIN map_piece LEFT JOIN properties ON name = 'from ' || "
      "keyframes.piece GROUP BY keyframes.piece ORDER BY is_map DESC, keyframes.piece",
      [&pieces](ColumnReader row) {
        PieceInfo piece;
        int isMap = 0;
        int keyframes = 0;
        row >> pieceIn(piece.piece) >> isMap >> countIn(keyframes) >> stampIn(piece.firstStamp_s) >>
            stampIn(piece.lastStamp_s) >> piece.from;
        piece.isMap = isMap != 0;
        piece.keyframes = static_cast<std::size_t>(keyframes);
        pieces.push_back(piece);
      });
  return pieces;
}

void readOrigins(SQLite::Database& database, MapHeader& header) {
  forEachRow(database, "property", "SELECT name, value FROM properties WHERE name LIKE 'from %'",
             [&header](ColumnReader row) {
               std::string name;
               std::string files;
               row >> name >> files;
               header.from[static_cast<std::uint32_t>(std::strtoul(name.c_str() + 5, nullptr, 10))] = files;
             });
}

}  // namespace

MapFileInfo readInfo(SQLite::Database& database) {
  MapFileInfo info;
  info.schemaVersion = database.execAndGet("PRAGMA user_version");
  info.keyframes = count(database, "SELECT count(*) FROM keyframes WHERE piece = (SELECT piece FROM map_piece)");
  info.parts = readParts(database);
  info.pieces = info.parts.size();
  info.keyframesElsewhere = count(database, "SELECT count(*) FROM keyframes") - info.keyframes;
  info.trackingPoints = count(database, "SELECT count(*) FROM points");
  info.loops = count(database, "SELECT count(*) FROM edges WHERE kind = 'loop'");
  info.cloudPoints = count(database,
                           "SELECT coalesce(sum(point_count), 0) FROM cloud_tiles JOIN keyframes ON keyframe = id "
                           "WHERE piece = (SELECT piece FROM map_piece)");
  info.objects = count(database, "SELECT count(*) FROM objects WHERE piece = (SELECT piece FROM map_piece)");
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
  readOrigins(database, header);
  forEachRow(database, "label", "SELECT class_id, name FROM labels ORDER BY class_id", [&header](ColumnReader row) {
    core::ClassId id = 0;
    std::string name;
    row >> id >> name;
    if (name.empty()) throw core::BlobError("it is empty");
    header.labels.rename(id, name);
  });
  return header;
}

mapping::SemanticMap readMap(SQLite::Database& database, CloudPart cloud, PiecePart pieces) {
  mapping::SemanticMap map;
  map.piece = mapPieceOf(database);
  map.labels = readHeader(database).labels;
  readKeyframes(database, map);
  readFreeFans(database, map);
  readGrounds(database, map);
  if (cloud == CloudPart::Include) readCloud(database, map);
  readObjects(database, map);
  readHints(database, map);
  map.nextObjectId = nextObjectId(database);
  map.zones = readZones(database);
  readFloorPlan(database, map);
  if (pieces == PiecePart::TheMap) keepOnlyTheMap(map);
  return map;
}

std::vector<odometry::Keyframe> readViews(SQLite::Database& database) {
  auto views = readKeyframesWithFeatures(database);
  for (const auto& edge : readEdges(database, "odometry")) {
    if (const auto view = views.find(edge.to); view != views.end()) view->second.T_previous_cam = edge.T_from_to;
  }
  forEachRow(database, "sighting of keyframe",
             "SELECT keyframe, point, keypoint, id IS NOT NULL FROM sightings LEFT JOIN points ON id = point "
             "ORDER BY keyframe, point",
             [&views](ColumnReader row) {
               odometry::KeyframeId keyframe = 0;
               odometry::PointId point = 0;
               std::uint64_t keypoint = 0;
               int isKnown = 0;
               row >> keyframe >> point >> keypoint >> isKnown;
               if (isKnown == 0) throw core::BlobError("it names a point that is not there");
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
    row >> idIn(id) >> p_map_m;
    points.emplace(id, p_map_m);
  });
  return points;
}

std::uint32_t readFreeSubmap(SQLite::Database& database) {
  std::uint32_t used = 0;
  forEachRow(database, "number of the newest",
             "SELECT 'piece', coalesce(max(piece), 0) AS piece FROM "
             "(SELECT max(stretch) AS piece FROM views UNION ALL SELECT max(piece) FROM keyframes)",
             [&used](ColumnReader row) {
               std::string name;
               row >> name >> pieceIn(used);
             });
  return used + 1;
}

std::vector<LoopEdge> readLoops(SQLite::Database& database) { return readEdges(database, "loop"); }

}  // namespace wardslam::storage
