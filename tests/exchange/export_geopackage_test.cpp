#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/map_export.h"

namespace wardslam::exchange {
namespace {

/// Values are those of OGC 12-128r17, GeoPackage 1.3.
class ExportGeoPackageTest : public testing::Test {
 protected:
  [[nodiscard]] SQLite::Database exported() const {
    exportGeoPackage(ward_, rooms_, file_);
    return SQLite::Database(file_.string());
  }

  /// The rows of a query, columns joined by "|".
  static std::string rows(SQLite::Database& database, const std::string& query) {
    SQLite::Statement statement(database, query);
    std::string text;
    while (statement.executeStep()) {
      for (int i = 0; i < statement.getColumnCount(); ++i) {
        text += (i > 0 ? "|" : "") + statement.getColumn(i).getString();
      }
      text += "\n";
    }
    return text;
  }

  static std::vector<double> doublesAt(const std::string& blob, std::size_t position, std::size_t count) {
    std::vector<double> values(count);
    if (blob.size() < position + count * sizeof(double)) throw std::runtime_error("the blob is too short");
    std::memcpy(values.data(), blob.data() + position, count * sizeof(double));
    return values;
  }

  mapping::SemanticMap ward_ = test::makeWard();
  building::Rooms rooms_ = {{{1, "ward", 32.0, {3, 2}, {{-1, -1}, {7, -1}, {7, 3}, {-1, 3}}}}, {}, {}};
  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "ward.gpkg";
};

TEST_F(ExportGeoPackageTest, IsAGeoPackageByItsNumbers) {
  auto database = exported();
  EXPECT_EQ(database.execAndGet("PRAGMA application_id").getInt(), 0x47504B47);
  EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), 10300);
  EXPECT_EQ(rows(database, "PRAGMA integrity_check"), "ok\n");
  EXPECT_EQ(rows(database, "PRAGMA foreign_key_check"), "");
}

TEST_F(ExportGeoPackageTest, KnowsTheThreeReferenceSystemsThatEachFileMustKnow) {
  auto database = exported();
  EXPECT_EQ(rows(database,
                 "SELECT srs_id, organization, organization_coordsys_id, substr(definition, 1, 9) "
                 "FROM gpkg_spatial_ref_sys ORDER BY srs_id"),
            "-1|NONE|-1|undefined\n0|NONE|0|undefined\n4326|EPSG|4326|GEOGCS[\"W\n");
}

TEST_F(ExportGeoPackageTest, LayersAreMetresInAnUndefinedCartesianSystem) {
  auto database = exported();
  EXPECT_EQ(rows(database,
                 "SELECT table_name, data_type, srs_id, min_x, min_y, max_x, max_y FROM gpkg_contents "
                 "ORDER BY table_name"),
            "objects|features|-1|-0.25|-0.25|6.25|4.0\nrooms|features|-1|-1.0|-1.0|7.0|3.0\n"
            "ways|features|-1|0.5|1.0|1.5|1.0\nzones|features|-1|-1.0|-1.0|7.0|5.0\n");
  EXPECT_EQ(rows(database,
                 "SELECT table_name, column_name, geometry_type_name, srs_id, z, m FROM gpkg_geometry_columns "
                 "ORDER BY table_name"),
            "objects|geom|POLYGON|-1|0|0\nrooms|geom|POLYGON|-1|0|0\nways|geom|LINESTRING|-1|0|0\n"
            "zones|geom|POLYGON|-1|0|0\n");
}

TEST_F(ExportGeoPackageTest, GeometriesHaveTheHeaderOfTheStandardAndAClosedRing) {
  auto database = exported();
  const std::string blob = database.execAndGet("SELECT geom FROM zones WHERE name = 'clean zone'").getString();
  ASSERT_EQ(blob.size(), 8U + 4 * 8 + 1 + 3 * 4 + 5 * 16);
  EXPECT_EQ(blob.substr(0, 2), "GP");
  EXPECT_EQ(blob[2], 0) << "version";
  EXPECT_EQ(blob[3], 0x03) << "little-endian, with an extent x, y, not empty";
  EXPECT_EQ(blob.substr(4, 4), "\xFF\xFF\xFF\xFF") << "srs_id -1";
  EXPECT_EQ(doublesAt(blob, 8, 4), (std::vector<double>{-1, 3, -1, 5}));
  EXPECT_EQ(blob.substr(40, 13), std::string("\1\3\0\0\0\1\0\0\0\5\0\0\0", 13)) << "a polygon, one ring, 5 points";
  EXPECT_EQ(doublesAt(blob, 53, 10), (std::vector<double>{-1, -1, 3, -1, 3, 5, -1, 5, -1, -1}));
}

TEST_F(ExportGeoPackageTest, HasWhatStandsThereWithItsAttributes) {
  auto database = exported();
  EXPECT_EQ(rows(database, "SELECT fid, name FROM zones"), "1|ward\n2|clean zone\n");
  EXPECT_EQ(rows(database, "SELECT fid FROM objects"), "1\n2\n3\n4\n5\n7\n") << "6 is gone";
  EXPECT_EQ(rows(database,
                 "SELECT class_id, class_name, probability, bottom_m, top_m, views, zone, state FROM objects "
                 "WHERE fid = 5"),
            "60|bed|0.75|0.0|0.8|5|ward|static\n");
}

TEST_F(ExportGeoPackageTest, ZonesSayWhatTheyAskOfRobots) {
  ward_.zones[0].type = mapping::ZoneType::Slow;
  ward_.zones[0].maxSpeed_mps = 0.5;
  auto database = exported();
  EXPECT_EQ(rows(database, "SELECT name, type, max_speed_mps, direction_rad IS NULL FROM zones"),
            "ward|slow|0.5|1\nclean zone|place||1\n");
}

TEST_F(ExportGeoPackageTest, HasRooms) {
  auto database = exported();
  EXPECT_EQ(rows(database, "SELECT fid, name, area_m2 FROM rooms"), "1|ward|32.0\n");
}

/// 30 s without a keyframe are a gap; a single place is no way.
TEST_F(ExportGeoPackageTest, HasTheWaysThatWereDriven) {
  ward_.keyframes.clear();
  for (const double at_s : {100.0, 101.0, 102.0, 132.0}) {
    auto& keyframe = ward_.keyframes[ward_.keyframes.size() + 1];
    keyframe.stamp_s = at_s;
    keyframe.T_map_cam.translation() = Eigen::Vector3d(at_s - 100.0, 1.0, 1.0);
    keyframe.piece = ward_.piece;
  }
  auto database = exported();
  EXPECT_EQ(rows(database, "SELECT fid, first_s, last_s FROM ways"), "1|100.0|102.0\n");
  const std::string blob = database.execAndGet("SELECT geom FROM ways").getString();
  EXPECT_EQ(blob.substr(40, 9), std::string("\1\2\0\0\0\3\0\0\0", 9)) << "a line of 3 points";
  EXPECT_EQ(doublesAt(blob, 49, 6), (std::vector<double>{0, 1, 1, 1, 2, 1}));
}

TEST_F(ExportGeoPackageTest, AMapWithoutAnythingHasLayersWithoutExtent) {
  ward_ = {};
  rooms_ = {};
  auto database = exported();
  EXPECT_EQ(rows(database, "SELECT count(*), count(min_x) FROM gpkg_contents"), "4|0\n");
}

TEST_F(ExportGeoPackageTest, TheSameMapMakesTheSameBytesAlsoOverAnOlderFile) {
  exportGeoPackage(ward_, rooms_, file_);
  const std::string first = test::readText(file_);
  folder_.write("ward.gpkg.partial", "left behind");
  exportGeoPackage(ward_, rooms_, file_);
  EXPECT_EQ(test::readText(file_), first);
}

TEST_F(ExportGeoPackageTest, WhatCannotBeWrittenIsAnInputError) {
  EXPECT_THROW(exportGeoPackage(ward_, rooms_, folder_.path() / "missing" / "ward.gpkg"), core::InputError);
}

}  // namespace
}  // namespace wardslam::exchange
