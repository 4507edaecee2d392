#include "zone_rows.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

#include "map_schema.h"
#include "wardslam/core/blob.h"

namespace wardslam::storage {
namespace {

using mapping::Zone;
using mapping::ZoneType;

class ZoneRowsTest : public testing::Test {
 protected:
  ZoneRowsTest() { migrateSchema(database_); }

  SQLite::Database database_{":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE};
};

TEST_F(ZoneRowsTest, ComeBackAsTheyWereWritten) {
  const std::vector<Zone> zones{
      {"slow", {{0, 0}, {2, 0}, {2, 1}}, ZoneType::Slow, 0.3},
      {"lane", {{0, 1}, {2, 1}, {2, 2}}, ZoneType::OneWay, 0.0, -1.25},
      {"bell", {{5, 1}, {6, 1}, {6, 2}}, ZoneType::Action, 0.0, 0.0, {{"ring", "dim"}, {"hum"}, {"brighten"}}},
      {"ward", {{0, 0}, {9, 0}, {9, 9}}}};
  writeZones(database_, {zones[1]});
  writeZones(database_, zones);
  const auto read = readZones(database_);
  ASSERT_EQ(read.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(read[i].name, zones[i].name);
    EXPECT_EQ(read[i].polygon_m, zones[i].polygon_m);
    EXPECT_EQ(read[i].type, zones[i].type);
    EXPECT_EQ(read[i].maxSpeed_mps, zones[i].maxSpeed_mps);
    EXPECT_EQ(read[i].direction_rad, zones[i].direction_rad);
    EXPECT_EQ(read[i].actions.entry, zones[i].actions.entry);
    EXPECT_EQ(read[i].actions.inside, zones[i].actions.inside);
    EXPECT_EQ(read[i].actions.exit, zones[i].actions.exit);
  }
}

TEST_F(ZoneRowsTest, WhatIsOfNoZoneIsTold) {
  database_.exec("PRAGMA foreign_keys = OFF; INSERT INTO zone_actions VALUES (7, 'entry', 0, 'ring')");
  EXPECT_THROW(static_cast<void>(readZones(database_)), std::exception);
}

TEST_F(ZoneRowsTest, AnActionThatIsMissingIsTold) {
  writeZones(database_, {{"bell", {{5, 1}, {6, 1}, {6, 2}}, ZoneType::Action, 0.0, 0.0, {{"ring", "dim"}, {}, {}}}});
  database_.exec("DELETE FROM zone_actions WHERE position = 0");
  EXPECT_THROW(static_cast<void>(readZones(database_)), std::exception);
}

TEST(ZoneRows, OfOlderFilesAskForNothing) {
  SQLite::Database database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  database.exec(
      "CREATE TABLE zones (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE);"
      "CREATE TABLE zone_corners (zone INTEGER, position INTEGER, x_m REAL, y_m REAL);"
      "INSERT INTO zones VALUES (1, 'ward'); INSERT INTO zone_corners VALUES (1, 0, 2, 3);"
      "PRAGMA user_version = 4");
  migrateSchema(database);
  const auto zones = readZones(database);
  ASSERT_EQ(zones.size(), 1U);
  EXPECT_EQ(zones[0].name, "ward");
  EXPECT_EQ(zones[0].type, ZoneType::Place);
  EXPECT_EQ(zones[0].polygon_m, std::vector<Eigen::Vector2d>{Eigen::Vector2d(2, 3)});
}

}  // namespace
}  // namespace wardslam::storage
