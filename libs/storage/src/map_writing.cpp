#include "map_writing.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <array>

#include "blob_codecs.h"
#include "lasting_features.h"
#include "map_reading.h"
#include "map_rows.h"
#include "zone_rows.h"

namespace wardslam::storage {
namespace {

void writeGround(SQLite::Statement& row, odometry::KeyframeId id, const core::GroundPlane& ground) {
  const Eigen::Matrix3d& c = ground.covariance;
  (ParameterBinder(row) << id << ground.normal_cam << ground.height_m << c(0, 0) << c(1, 1) << c(2, 2) << c(0, 1)
                        << c(0, 2) << c(1, 2))
      .run();
}

void writeKeyframes(SQLite::Database& database, const MapChanges& changes) {
  SQLite::Statement upsert(database,
                           "INSERT INTO keyframes VALUES (?,?, ?,?,?, ?,?,?,?, ?, ?) ON CONFLICT (id) DO UPDATE SET "
                           "stamp_s = excluded.stamp_s, x_m = excluded.x_m, y_m = excluded.y_m, z_m = excluded.z_m, "
                           "qx = excluded.qx, qy = excluded.qy, qz = excluded.qz, qw = excluded.qw, "
                           "zone = excluded.zone, piece = excluded.piece");
  SQLite::Statement fan(database,
                        "INSERT INTO free_fans VALUES (?,?) ON CONFLICT (keyframe) DO UPDATE SET "
                        "points = excluded.points WHERE points <> excluded.points");
  SQLite::Statement ground(database, "INSERT OR REPLACE INTO grounds VALUES (?, ?,?,?, ?, ?,?,?, ?,?,?)");
  for (const auto& [id, keyframe] : changes.keyframes) {
    (ParameterBinder(upsert) << id << keyframe.stamp_s << keyframe.T_map_cam << keyframe.zone << keyframe.piece).run();
    if (!keyframe.freeFan_cam_m.empty()) (ParameterBinder(fan) << id << encodeFan(keyframe.freeFan_cam_m)).run();
    if (keyframe.ground) writeGround(ground, id, *keyframe.ground);
  }
}

std::int64_t cameraId(SQLite::Database& database, const core::CameraModel& c) {
  const auto bindTo = [&c](SQLite::Statement& statement) {
    return ParameterBinder(statement) << c.width_px << c.height_px << c.fx_px << c.fy_px << c.cx_px << c.cy_px << c.k1
                                      << c.k2 << c.p1 << c.p2 << c.k3;
  };
  SQLite::Statement insert(database,
                           "INSERT OR IGNORE INTO cameras (width_px, height_px, fx_px, fy_px, cx_px, cy_px, k1, k2, "
                           "p1, p2, k3) VALUES (?,?, ?,?,?,?, ?,?,?,?,?)");
  bindTo(insert).run();
  SQLite::Statement find(database,
                         "SELECT id FROM cameras WHERE (width_px, height_px, fx_px, fy_px, cx_px, cy_px, k1, k2, p1, "
                         "p2, k3) = (?,?, ?,?,?,?, ?,?,?,?,?)");
  bindTo(find);
  find.executeStep();
  return find.getColumn(0).getInt64();
}

/// What points turned out to be, since the file was opened: sightings under the old ids may still come.
class FusedPoints {
 public:
  explicit FusedPoints(SQLite::Database& database)
      : insert_(database, "INSERT OR REPLACE INTO temp.fused VALUES (?,?)"),
        find_(database, "SELECT into_point FROM temp.fused WHERE from_point = ?") {}

  void add(odometry::PointId from, odometry::PointId into) { (ParameterBinder(insert_) << from << into).run(); }

  odometry::PointId currentIdOf(odometry::PointId point) {
    ParameterBinder(find_) << point;
    while (find_.executeStep()) {
      ColumnReader(find_) >> point;
      ParameterBinder(find_) << point;
    }
    return point;
  }

 private:
  SQLite::Statement insert_;
  SQLite::Statement find_;
};

class SightingWriter {
 public:
  explicit SightingWriter(SQLite::Database& database)
      : fused_(database),
        point_(database, "INSERT OR IGNORE INTO points VALUES (?, ?,?,?)"),
        sighting_(database, "INSERT OR IGNORE INTO sightings SELECT ?, id, ? FROM points WHERE id = ?") {}

  /// A point not known yet is made from the key point's depth. Without depth nobody knows where it is: it was removed
  /// meanwhile, and so this sighting is left out.
  void write(const odometry::Keyframe& view, const Eigen::Isometry3d& T_map_cam, const odometry::Sighting& sighting) {
    const odometry::PointId point = fused_.currentIdOf(sighting.point);
    const auto& keypoint = view.features.keypoints[sighting.keypoint];
    if (keypoint.hasDepth()) {
      const Eigen::Vector2d pixel(keypoint.undistorted_px.x, keypoint.undistorted_px.y);
      const Eigen::Vector3d p_cam_m = view.camera.unproject(pixel, static_cast<double>(keypoint.depth_m));
      (ParameterBinder(point_) << point << Eigen::Vector3d(T_map_cam * p_cam_m)).run();
    }
    (ParameterBinder(sighting_) << view.id << std::uint64_t{sighting.keypoint} << point).run();
  }

 private:
  FusedPoints fused_;
  SQLite::Statement point_;
  SQLite::Statement sighting_;
};

void writeEdge(SQLite::Database& database, const char* kind, const LoopEdge& edge) {
  SQLite::Statement insert(database, "INSERT OR REPLACE INTO edges VALUES (?, ?,?, ?,?,?, ?,?,?,?, ?)");
  (ParameterBinder(insert) << kind << edge.from << edge.to << edge.T_from_to << edge.inliers).run();
}

bool isKnown(SQLite::Database& database, odometry::KeyframeId keyframe, std::uint32_t stretch) {
  SQLite::Statement find(database, "SELECT 1 FROM views WHERE keyframe = ? AND stretch = ?");
  ParameterBinder(find) << keyframe << stretch;
  return find.executeStep();
}

Eigen::Isometry3d poseOf(SQLite::Database& database, odometry::KeyframeId keyframe) {
  SQLite::Statement find(database, "SELECT x_m, y_m, z_m, qx, qy, qz, qw FROM keyframes WHERE id = ?");
  ParameterBinder(find) << keyframe;
  Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
  if (find.executeStep()) ColumnReader(find) >> T_map_cam;
  return T_map_cam;
}

void writeViews(SQLite::Database& database, const MapChanges& changes) {
  SQLite::Statement insert(database, "INSERT INTO views VALUES (?,?,?,?)");
  SQLite::Statement noiseRow(database, "INSERT INTO depth_noises VALUES (?,?,?,?)");
  SQLite::Statement depth(database, "INSERT INTO depth_views VALUES (?,?)");
  SightingWriter sightings(database);
  for (const auto& view : changes.views) {
    const auto camera = static_cast<std::uint64_t>(cameraId(database, view->camera));
    (ParameterBinder(insert) << view->id << view->submap << camera << encodeFeatures(view->features)).run();
    const core::DepthNoise& noise = view->camera.depthNoise;
    (ParameterBinder(noiseRow) << view->id << noise.least_m << noise.growth_per_m << noise.from_m).run();
    if (view->depth) (ParameterBinder(depth) << view->id << encodeDepthView(*view->depth)).run();
    const Eigen::Isometry3d T_map_cam = poseOf(database, view->id);
    for (const auto& sighting : view->sightings) sightings.write(*view, T_map_cam, sighting);
    if (view->T_previous_cam && isKnown(database, view->id - 1, view->submap)) {
      writeEdge(database, "odometry", {view->id - 1, view->id, *view->T_previous_cam});
    }
  }
}

class PointRemover {
 public:
  explicit PointRemover(SQLite::Database& database)
      : sightings_(database, "DELETE FROM sightings WHERE point = ?"),
        point_(database, "DELETE FROM points WHERE id = ?") {}

  void remove(odometry::PointId point) {
    (ParameterBinder(sightings_) << point).run();
    (ParameterBinder(point_) << point).run();
  }

 private:
  SQLite::Statement sightings_;
  SQLite::Statement point_;
};

void fusePoints(SQLite::Database& database, const MapChanges& changes) {
  FusedPoints fused(database);
  for (const auto& [from, into] : changes.fusedPoints) fused.add(from, into);
  SQLite::Statement keep(database, "INSERT OR IGNORE INTO points SELECT ?, x_m, y_m, z_m FROM points WHERE id = ?");
  SQLite::Statement rename(database, "UPDATE OR IGNORE sightings SET point = ? WHERE point = ?");
  PointRemover remover(database);
  for (const auto& [from, next] : changes.fusedPoints) {
    const odometry::PointId into = fused.currentIdOf(from);
    (ParameterBinder(keep) << into << from).run();
    (ParameterBinder(rename) << into << from).run();
    remover.remove(from);
  }
}

void writePoints(SQLite::Database& database, const MapChanges& changes) {
  fusePoints(database, changes);
  PointRemover remover(database);
  for (const auto point : changes.removedPoints) remover.remove(point);
  SQLite::Statement move(database, "UPDATE points SET (x_m, y_m, z_m) = (?,?,?) WHERE id = ?");
  for (const auto& [point, p_map_m] : changes.p_map_m) (ParameterBinder(move) << p_map_m << point).run();
}

/// The way goes on from the keyframe before to the one behind.
void bridgeWay(SQLite::Database& database, odometry::KeyframeId removed) {
  SQLite::Statement find(database,
                         "SELECT a.from_keyframe, b.to_keyframe, a.x_m, a.y_m, a.z_m, a.qx, a.qy, a.qz, a.qw, b.x_m, "
                         "b.y_m, b.z_m, b.qx, b.qy, b.qz, b.qw FROM edges a JOIN edges b ON b.from_keyframe = "
                         "a.to_keyframe WHERE a.kind = 'odometry' AND b.kind = 'odometry' AND a.to_keyframe = ?");
  ParameterBinder(find) << removed;
  if (!find.executeStep()) return;
  LoopEdge bridge;
  Eigen::Isometry3d T_from_removed = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_removed_to = Eigen::Isometry3d::Identity();
  ColumnReader(find) >> bridge.from >> bridge.to >> T_from_removed >> T_removed_to;
  bridge.T_from_to = T_from_removed * T_removed_to;
  writeEdge(database, "odometry", bridge);
}

void removeKeyframes(SQLite::Database& database, const MapChanges& changes) {
  constexpr std::array kSteps = {
      "DELETE FROM points WHERE id IN (SELECT point FROM sightings WHERE keyframe = ?1) AND NOT EXISTS "
      "(SELECT 1 FROM sightings s WHERE s.point = points.id AND s.keyframe <> ?1)",
      "DELETE FROM sightings WHERE keyframe = ?1",
      "DELETE FROM edges WHERE from_keyframe = ?1 OR to_keyframe = ?1",
      "DELETE FROM depth_noises WHERE keyframe = ?1",
      "DELETE FROM depth_views WHERE keyframe = ?1",
      "DELETE FROM views WHERE keyframe = ?1",
      "DELETE FROM free_fans WHERE keyframe = ?1",
      "DELETE FROM grounds WHERE keyframe = ?1",
      "DELETE FROM cloud_tiles WHERE keyframe = ?1",
      "DELETE FROM tile_memories WHERE keyframe = ?1",
      "DELETE FROM keyframes WHERE id = ?1"};
  database.exec("PRAGMA defer_foreign_keys = ON");  // until the transaction ends
  for (const auto removed : changes.removedKeyframes) {
    bridgeWay(database, removed);
    for (const char* step : kSteps) {
      SQLite::Statement statement(database, step);
      (ParameterBinder(statement) << removed).run();
    }
  }
}

void replaceGraph(SQLite::Database& database, const GraphContent& graph) {
  database.exec("DELETE FROM sightings; DELETE FROM points");
  SQLite::Statement pointRow(database, "INSERT INTO points VALUES (?, ?,?,?)");
  for (const auto& [point, p_map_m] : graph.p_map_m) (ParameterBinder(pointRow) << point << p_map_m).run();
  SQLite::Statement sightingRow(database, "INSERT INTO sightings VALUES (?,?,?)");
  for (const auto& [keyframe, sightings] : keepLastingFeatures(database, graph.sightings)) {
    for (const auto& [point, keypoint] : sightings) {
      (ParameterBinder(sightingRow) << keyframe << point << std::uint64_t{keypoint}).run();
    }
  }
}

bool isAmong(const LoopEdge& loop, const std::vector<LoopEdge>& loops) {
  return std::any_of(loops.begin(), loops.end(), [&loop](const LoopEdge& other) {
    return loop.from == other.from && loop.to == other.to && loop.inliers == other.inliers &&
           loop.T_from_to.matrix() == other.T_from_to.matrix();
  });
}

/// A loop that is there already stays as it stands: what is read and written again is off by rounding, a bit more in
/// every run.
void writeLoops(SQLite::Database& database, const MapChanges& changes) {
  if (!changes.graph && changes.loops.empty()) return;
  const auto before = readLoops(database);
  SQLite::Statement remove(database, "DELETE FROM edges WHERE kind = 'loop' AND from_keyframe = ? AND to_keyframe = ?");
  for (const auto& loop : before) {
    if (changes.graph && !isAmong(loop, changes.loops)) (ParameterBinder(remove) << loop.from << loop.to).run();
  }
  for (const auto& loop : changes.loops) {
    if (!isAmong(loop, before)) writeEdge(database, "loop", loop);
  }
}

void writeCloud(SQLite::Database& database, const MapChanges& changes) {
  SQLite::Statement replace(database, "INSERT OR REPLACE INTO cloud_tiles VALUES (?,?,?)");
  SQLite::Statement remove(database, "DELETE FROM cloud_tiles WHERE keyframe = ?");
  SQLite::Statement forget(database, "DELETE FROM tile_memories WHERE keyframe = ?");
  for (const auto& [keyframe, tile] : changes.cloud) {
    (ParameterBinder(forget) << keyframe).run();  // what is remembered is of the tile as it was
    if (tile.points.empty()) {
      (ParameterBinder(remove) << keyframe).run();
    } else {
      (ParameterBinder(replace) << keyframe << std::uint64_t{tile.points.size()} << encodeTile(tile)).run();
    }
  }
}

void removeObjects(SQLite::Database& database, const MapChanges& changes) {
  SQLite::Statement object(database, "DELETE FROM objects WHERE id = ?");
  SQLite::Statement box(database, "DELETE FROM object_boxes WHERE id = ?");
  SQLite::Statement hint(database, "DELETE FROM object_hints WHERE object = ?");
  for (const auto id : changes.removedObjects) {
    (ParameterBinder(object) << id).run();
    (ParameterBinder(box) << id).run();
    (ParameterBinder(hint) << id).run();
  }
}

void writeObjects(SQLite::Database& database, const MapChanges& changes) {
  SQLite::Statement row(database,
                        "INSERT OR REPLACE INTO objects VALUES (?,?,?, ?,?,?, ?,?,?, ?,?,?, ?,?,?, ?,?,?,?, ?,?,?, "
                        "?,?,?, ?,?,?, ?,?, ?)");
  SQLite::Statement boxRow(database, "INSERT OR REPLACE INTO object_boxes VALUES (?, ?,?, ?,?, ?,?)");
  SQLite::Statement noHint(database, "DELETE FROM object_hints WHERE object = ?");
  SQLite::Statement hintRow(database, "INSERT INTO object_hints VALUES (?,?,?)");
  for (const auto& object : changes.objects) {
    const auto& [red, green, blue] = object.color_rgb;
    const Eigen::Vector3d& min = object.box_m.min();
    const Eigen::Vector3d& max = object.box_m.max();
    ParameterBinder values(row);
    values << object.id << int{object.classId} << object.probability << object.centroid_m << min << max;
    values << object.orientedBox.T_map_box << object.orientedBox.size_m << int{red} << int{green} << int{blue};
    values << object.firstSeen_s << object.lastSeen_s << object.views << object.zone << toString(object.state)
           << object.piece;
    values.run();
    ParameterBinder box(boxRow);
    box << object.id << min.x() << max.x() << min.y() << max.y() << min.z() << max.z();
    box.run();
    (ParameterBinder(noHint) << object.id).run();
    if (!object.maybeSameAs) continue;
    (ParameterBinder(hintRow) << object.id << object.maybeSameAs->id << object.maybeSameAs->probability).run();
  }
}

/// All that is remembered of objects is replaced; tiles that are not named are as they were.
void writeMemory(SQLite::Database& database, const mapping::MapMemory& memory) {
  SQLite::Statement tileRow(database, "INSERT OR REPLACE INTO tile_memories VALUES (?,?)");
  for (const auto& [id, tile] : memory.tiles) (ParameterBinder(tileRow) << id << encodeTileMemory(tile)).run();
  database.exec("DELETE FROM object_memories; DELETE FROM object_votes; DELETE FROM object_pairs");
  SQLite::Statement objectRow(database, "INSERT INTO object_memories VALUES (?,?,?,?, ?,?, ?,?,?, ?,?,?,?, ?,?, ?)");
  SQLite::Statement voteRow(database, "INSERT INTO object_votes VALUES (?,?,?)");
  for (const auto& [id, object] : memory.objects) {
    ParameterBinder values(objectRow);
    values << id << object.views << object.expected << object.missed << object.firstSeen_s << object.lastSeen_s;
    values << Eigen::Vector3d(object.lastPlace_m.cast<double>()) << object.handled_s << object.viewsToRest;
    values << std::uint64_t{object.erased} << object.gone_s << int{object.placeWasEmpty} << toString(object.state)
           << object.piece;
    values.run();
    for (const auto& [classId, confidence] : object.votes) {
      (ParameterBinder(voteRow) << id << int{classId} << confidence).run();
    }
  }
  SQLite::Statement pairRow(database, "INSERT INTO object_pairs VALUES (?,?,?,?)");
  for (const auto& [ids, pair] : memory.pairs) {
    (ParameterBinder(pairRow) << ids.first << ids.second << pair.together << pair.apart).run();
  }
}

/// Besides those there are; a name or a number that nothing is called by gives way.
void writeLabels(SQLite::Database& database, const core::LabelSpace& labels) {
  SQLite::Statement makeWay(database,
                            "DELETE FROM labels WHERE (class_id = ?1) <> (name = ?2) "
                            "AND class_id NOT IN (SELECT class_id FROM objects)");
  SQLite::Statement label(database, "INSERT OR IGNORE INTO labels VALUES (?,?)");
  for (int id = 0; id <= UINT8_MAX; ++id) {
    const std::string& name = labels.name(static_cast<core::ClassId>(id));
    if (name.empty()) continue;
    (ParameterBinder(makeWay) << id << name).run();
    (ParameterBinder(label) << id << name).run();
  }
}

void writeMapPiece(SQLite::Database& database, std::uint32_t piece) {
  SQLite::Statement replace(database, "INSERT OR REPLACE INTO properties VALUES ('map_piece', ?)");
  (ParameterBinder(replace) << piece).run();
}

void writeFloorPlan(SQLite::Database& database, const mapping::FloorPlan& plan) {
  SQLite::Statement replace(database, "INSERT OR REPLACE INTO floor_plan VALUES (1, ?, ?,?, ?)");
  (ParameterBinder(replace) << plan.resolution_m << plan.origin_m << encodeCells(plan.cells)).run();
}

}  // namespace

void writeHeader(SQLite::Database& database, const MapHeader& header) {
  SQLite::Statement property(database, "INSERT INTO properties VALUES (?,?)");
  (ParameterBinder(property) << "options" << header.options).run();
  for (const auto& [piece, files] : header.from) {
    (ParameterBinder(property) << "from " + std::to_string(piece) << files).run();
  }
  writeLabels(database, header.labels);
}

void writeChanges(SQLite::Database& database, const MapChanges& changes) {
  database.exec("CREATE TEMP TABLE IF NOT EXISTS fused (from_point INTEGER PRIMARY KEY, into_point INTEGER NOT NULL)");
  writeKeyframes(database, changes);
  writeViews(database, changes);
  writePoints(database, changes);
  removeKeyframes(database, changes);
  if (changes.graph) replaceGraph(database, *changes.graph);
  writeLoops(database, changes);
  writeCloud(database, changes);
  removeObjects(database, changes);
  writeObjects(database, changes);
  if (changes.labels) writeLabels(database, *changes.labels);
  if (changes.mapPiece) writeMapPiece(database, *changes.mapPiece);
  if (changes.zones) writeZones(database, *changes.zones);
  if (changes.outdatesFloorPlan) database.exec("DELETE FROM floor_plan");
  if (changes.memory) writeMemory(database, *changes.memory);
  if (changes.nextObjectId != 0) {
    SQLite::Statement property(database,
                               "INSERT INTO properties VALUES ('next_object_id', ?) ON CONFLICT (name) DO "
                               "UPDATE SET value = max(value, excluded.value)");
    (ParameterBinder(property) << changes.nextObjectId).run();
  }
  if (changes.floorPlan) writeFloorPlan(database, *changes.floorPlan);
}

}  // namespace wardslam::storage
