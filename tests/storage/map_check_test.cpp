#include "map_check.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "storage/stored_ward.h"
#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::storage {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class MapCheckTest : public testing::Test {
 protected:
  /// The hand-made ward, changed by a statement of SQL.
  MapFile damagedWard(const std::string& sql) {
    const auto ward = test::makeWard();
    {
      MapChanges changes = everythingOf(ward);
      for (const odometry::KeyframeId id : {1, 2}) changes.views.push_back(test::makeView(id, ward));
      MapFile::create(path_, {ward.labels, ""}).write(changes);
    }
    SQLite::Database(path_.string(), SQLite::OPEN_READWRITE).exec(sql);
    return MapFile::open(path_);
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "ward.wardmap";
};

TEST_F(MapCheckTest, TablesOfOtherProgramsMayHaveAnyName) {
  const std::string odd = R"sql("notes"";--'of ours" ("a ""b"" c" INTEGER))sql";
  EXPECT_THAT(damagedWard("CREATE TABLE " + odd).check(), IsEmpty());
}

TEST_F(MapCheckTest, FindsWhatIsOutOfBounds) {
  const std::vector<std::pair<std::string, std::string>> damages = {
      {"UPDATE keyframes SET x_m = 1e308 WHERE id = 2", "x_m is impossible"},
      {"UPDATE keyframes SET x_m = 'abc' WHERE id = 2", "x_m is impossible"},
      {"UPDATE keyframes SET qw = 1e300 WHERE id = 2", "qw is impossible"},
      {"UPDATE keyframes SET stamp_s = -1e18 WHERE id = 2", "stamp_s is impossible"},
      {"UPDATE cameras SET fx_px = 0", "fx_px is impossible"},
      {"UPDATE cameras SET fy_px = 1e-300", "fy_px is impossible"},
      {"UPDATE cameras SET fx_px = -525", "fx_px is impossible"},
      {"UPDATE cameras SET cx_px = 1e300", "cx_px is impossible"},
      {"UPDATE cameras SET k1 = 1e300", "k1 is impossible"},
      {"UPDATE cameras SET width_px = -640", "width_px is impossible"},
      {"UPDATE cameras SET height_px = 100000", "height_px is impossible"},
      {"UPDATE points SET y_m = 1e300", "y_m is impossible"},
      {"UPDATE grounds SET height_m = 1e300", "height_m is impossible"},
      {"UPDATE grounds SET variance_1 = -1", "variance_1 is impossible"},
      {"UPDATE grounds SET normal_z = 0, normal_y = 0, normal_x = 0", "normal has no direction"},
      {"UPDATE grounds SET keyframe = 99 WHERE keyframe = 1", "row of grounds refers to a missing row"},
      {"UPDATE zone_corners SET x_m = 1e300", "x_m is impossible"},
      {"UPDATE floor_plan SET resolution_m = 1e-9", "resolution_m is impossible"},
      {"UPDATE floor_plan SET resolution_m = 1e9", "resolution_m is impossible"},
      {"UPDATE floor_plan SET origin_x_m = 1e308", "origin_x_m is impossible"},
      {"UPDATE objects SET centroid_x_m = 1e308 WHERE id = 3", "centroid_x_m is impossible"},
      {"UPDATE objects SET probability = 7 WHERE id = 3", "probability is impossible"},
      {"UPDATE objects SET last_seen_s = -1e18 WHERE id = 3", "last_seen_s is impossible"},
      {"UPDATE objects SET box_width_m = -1 WHERE id = 3", "negative size"},
      {"UPDATE objects SET min_z_m = max_z_m + 1 WHERE id = 3; DELETE FROM object_boxes WHERE id = 3; INSERT INTO "
       "object_boxes SELECT id, min_x_m, max_x_m, min_y_m, max_y_m, max_z_m, min_z_m FROM objects WHERE id = 3",
       "inside out"},
      {"UPDATE views SET stretch = -1 WHERE keyframe = 2", "impossible stretch"}};
  for (const auto& [sql, complaint] : damages) {
    EXPECT_THAT(damagedWard(sql).check(), testing::Contains(HasSubstr(complaint))) << sql;
  }
}

TEST_F(MapCheckTest, WhatIsOutOfBoundsIsNotReadEither) {
  for (const char* sql : {"UPDATE keyframes SET x_m = 1e308 WHERE id = 2", "UPDATE floor_plan SET resolution_m = 1e-9",
                          "UPDATE objects SET centroid_x_m = 1e308 WHERE id = 3"}) {
    const auto file = damagedWard(sql);
    EXPECT_THROW((void)file.read(), core::InputError) << sql;
  }
  for (const char* sql : {"UPDATE cameras SET fx_px = 0", "UPDATE cameras SET width_px = -640"}) {
    const auto file = damagedWard(sql);
    EXPECT_THROW((void)file.readViews(), core::InputError) << sql;
  }
}

using WholeWardCheckTest = StoredWard;

TEST_F(WholeWardCheckTest, ASoundFileHasNothingToComplainAbout) {
  writeWard();
  EXPECT_THAT(MapFile::open(path_).check(), IsEmpty());
}

TEST_F(WholeWardCheckTest, FindsWhatDoesNotFitTogether) {
  const std::vector<std::pair<std::string, std::string>> damages = {
      {"DELETE FROM object_boxes WHERE id = 3", "missing in the index of boxes"},
      {"UPDATE objects SET max_x_m = 99 WHERE id = 3", "missing in the index of boxes"},
      {"INSERT INTO object_boxes VALUES (77, 0, 1, 0, 1, 0, 1)", "belong to no object"},
      {"UPDATE objects SET zone = 'kitchen' WHERE id = 3", "zone that is not defined"},
      {"UPDATE objects SET class_id = 200 WHERE id = 3", "class without a name"},
      {"UPDATE objects SET class_id = 300 WHERE id = 3", "class_id is impossible"},
      {"DELETE FROM objects WHERE id = 1; DELETE FROM object_boxes WHERE id = 1", "belong to a missing object"},
      {"UPDATE sightings SET keypoint = 10 WHERE keyframe = 2 AND point = 23", "key point that is not there"},
      {"PRAGMA foreign_keys = OFF; DELETE FROM cameras", "missing row of cameras"},
      {"INSERT INTO points VALUES (555, 0, 0, 0)", "seen by no keyframe"},
      {"UPDATE keyframes SET qx = 0, qy = 0, qz = 0, qw = 0 WHERE id = 2", "quaternion is zero"},
      {"UPDATE keyframes SET x_m = 9e999 WHERE id = 2", "x_m is impossible"},
      {"UPDATE cloud_tiles SET points = zeroblob(20) WHERE keyframe = 2", "cloud tile of keyframe 2"},
      {"UPDATE views SET features = x'46' WHERE keyframe = 2", "features of keyframe 2"},
      {"UPDATE free_fans SET points = x'5301' WHERE keyframe = 2", "free fan of keyframe 2"},
      {"UPDATE floor_plan SET cells = x'4701ff'", "floor plan 1"}};
  for (const auto& [sql, complaint] : damages) {
    writeWard();
    runSql(sql);
    EXPECT_THAT(MapFile::open(path_).check(), testing::Contains(HasSubstr(complaint))) << sql;
  }
}

bool mayBeNegative(const std::string& column) {
  const std::set<std::string> some = {
      "x_m",          "y_m",        "z_m",      "qx",       "qy",       "qz",       "qw",           "cx_px",
      "cy_px",        "k1",         "k2",       "p1",       "p2",       "k3",       "centroid_x_m", "centroid_y_m",
      "centroid_z_m", "box_x_m",    "box_y_m",  "box_z_m",  "box_qx",   "box_qy",   "box_qz",       "box_qw",
      "origin_x_m",   "origin_y_m", "height_m", "last_x_m", "last_y_m", "last_z_m", "value",        "direction_rad"};
  return some.count(column) > 0;
}

/// A ward with a row in every table, and each value of each column falsified in turn.
class EveryColumnTest : public WholeWardCheckTest {
 protected:
  struct Column {
    std::string table;
    std::string name;
    std::string row;  ///< SQL: one row of the table.
  };

  void SetUp() override {
    ward_.nextObjectId = 8;
    ward_.zones[1].type = mapping::ZoneType::Action;
    ward_.zones[1].actions = {{"ring"}, {}, {"hush"}};
    ward_.objects[7].maybeSameAs = mapping::MaybeSame{6, 0.25};
    MapFile file = writeWard();
    MapChanges changes;
    changes.mapPiece = 0;
    mapping::MapMemory& memory = changes.memory.emplace();
    memory.tiles[2].resize(3);
    for (const mapping::ObjectId id : {1, 2}) {
      memory.objects[id].votes[test::kChair] = 2.5;
      memory.objects[id].views = 3;
      memory.objects[id].lastSeen_s = test::kWardEnd_s;
    }
    memory.pairs[{1, 2}] = {1, 4};
    file.write(changes);
    EXPECT_THAT(file.check(), IsEmpty());
    sound_ = test::readText(path_);
  }

  std::vector<Column> columns() const {
    SQLite::Database database(path_.string());
    SQLite::Statement find(database,
                           "SELECT m.name, c.name, (SELECT group_concat(p.name) FROM pragma_table_info(m.name) p WHERE "
                           "p.pk > 0) FROM sqlite_master m, pragma_table_info(m.name) c WHERE m.type = 'table' AND "
                           "m.name NOT LIKE 'object_boxes_%'");
    std::vector<Column> columns;
    while (find.executeStep()) {
      const std::string table = find.getColumn(0);
      const std::string key = table == "object_boxes" ? "id" : find.getColumn(2).getString();
      columns.push_back({table, find.getColumn(1), "(" + key + ") = (SELECT " + key + " FROM " + table + " LIMIT 1)"});
    }
    return columns;
  }

  /// False: SQLite itself refuses that, whoever asks.
  bool falsify(const Column& column, const std::string& value) const {
    std::ofstream(path_, std::ios::binary) << sound_;
    SQLite::Database database(path_.string(), SQLite::OPEN_READWRITE);
    database.exec("PRAGMA ignore_check_constraints = ON; PRAGMA synchronous = OFF; PRAGMA journal_mode = MEMORY");
    try {
      return database.exec("UPDATE " + column.table + " SET " + column.name + " = " + value + " WHERE " + column.row) >
             0;
    } catch (const SQLite::Exception&) {
      return false;
    }
  }

  /// Whatever is wrong, readers end with one sentence or with a map.
  void expectNoCrash(const MapFile& file, const std::string& what) const {
    const std::vector<std::function<void()>> readers = {
        [&] { (void)file.info(); },       [&] { (void)file.header(); },    [&] { (void)file.read(); },
        [&] { (void)file.readMemory(); }, [&] { (void)file.readViews(); }, [&] { (void)file.readFreeSubmap(); },
        [&] { (void)file.readPoints(); }, [&] { (void)file.readLoops(); }};
    for (const auto& read : readers) {
      try {
        read();
      } catch (const core::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("ward.wardmap")) << what;
      }
    }
  }

  std::string sound_;
};

TEST_F(EveryColumnTest, HasARowToFalsify) {
  for (const auto& column : columns()) {
    SQLite::Database database(path_.string());
    EXPECT_GT(database.execAndGet("SELECT count(*) FROM " + column.table).getInt(), 0) << column.table;
  }
}

TEST_F(EveryColumnTest, IsNamedWhenFalsified) {
  // Texts that may be anything: the configuration of the run is told and not read, classes and actions may be called
  // anything, and a fact of another name is none that is known.
  const auto mayBeAnything = [](const Column& column, const std::string& value) {
    if (column.table == "properties") return column.name == "name" || value == "'abc'";
    if (column.table == "zone_actions") return column.name == "action" && value != "x'00'";
    return column.table == "labels" && (column.name == "name" || value == "'abc'");
  };
  std::size_t tried = 0;
  for (const auto& column : columns()) {
    for (const char* value : {"9e999", "-1e300", "-5", "9000000000000000000", "'abc'", "x'00'"}) {
      const bool isNumber = std::string(value) == "-5";
      if (!falsify(column, value)) continue;
      ++tried;
      const std::string what = column.table + "." + column.name + " = " + value;
      const auto file = MapFile::open(path_);
      expectNoCrash(file, what);
      // -5 is a good place, pixel or angle; it is none of a count, a number or a length.
      if (mayBeAnything(column, value) || (isNumber && mayBeNegative(column.name))) continue;
      EXPECT_THAT(file.check(), testing::Not(IsEmpty())) << what;
    }
  }
  EXPECT_GT(tried, 600U);
}

TEST_F(EveryColumnTest, NamesNothingThatIsNotThere) {
  const std::vector<std::pair<std::string, std::string>> references = {{"free_fans", "keyframe"},
                                                                       {"views", "keyframe"},
                                                                       {"views", "camera"},
                                                                       {"edges", "from_keyframe"},
                                                                       {"edges", "to_keyframe"},
                                                                       {"depth_noises", "keyframe"},
                                                                       {"depth_views", "keyframe"},
                                                                       {"grounds", "keyframe"},
                                                                       {"sightings", "keyframe"},
                                                                       {"sightings", "point"},
                                                                       {"sightings", "keypoint"},
                                                                       {"cloud_tiles", "keyframe"},
                                                                       {"tile_memories", "keyframe"},
                                                                       {"objects", "class_id"},
                                                                       {"objects", "piece"},
                                                                       {"object_hints", "object"},
                                                                       {"object_hints", "maybe_same_as"},
                                                                       {"object_votes", "object"},
                                                                       {"zone_corners", "zone"},
                                                                       {"zone_actions", "zone"},
                                                                       {"objects", "id"},
                                                                       {"object_boxes", "id"},
                                                                       {"keyframes", "id"},
                                                                       {"keyframes", "piece"},
                                                                       {"points", "id"},
                                                                       {"cameras", "id"},
                                                                       {"zones", "id"}};
  for (const auto& column : columns()) {
    const bool refers =
        std::find(references.begin(), references.end(), std::pair(column.table, column.name)) != references.end();
    if (!refers || !falsify(column, "4242")) continue;
    const std::string what = column.table + "." + column.name + " = 4242";
    const auto file = MapFile::open(path_);
    expectNoCrash(file, what);
    EXPECT_THAT(file.check(), testing::Not(IsEmpty())) << what;
  }
}

}  // namespace
}  // namespace wardslam::storage
