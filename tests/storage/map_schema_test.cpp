#include "map_schema.h"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <string>

#include "storage/stored_ward.h"

namespace wardslam::storage {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

using MapSchemaTest = StoredWard;

/// What the fifth version added, taken away.
constexpr const char* kBackToTheFourth =
    "DROP TABLE zone_actions; ALTER TABLE zones DROP COLUMN type; ALTER TABLE zones DROP COLUMN max_speed_mps; "
    "ALTER TABLE zones DROP COLUMN direction_rad; PRAGMA user_version = 4";

TEST_F(MapSchemaTest, BringsAFileOfTheFirstVersionUpToDate) {
  writeWard();
  runSql(kBackToTheFourth);
  for (const char* table : {"depth_noises", "object_hints", "tile_memories", "object_memories", "object_votes",
                            "object_pairs", "grounds", "depth_views"}) {
    runSql(std::string("DROP TABLE ") + table);
  }
  runSql(
      "ALTER TABLE edges DROP COLUMN inliers; DROP VIEW map_piece; ALTER TABLE keyframes DROP COLUMN piece; "
      "ALTER TABLE objects DROP COLUMN piece; PRAGMA user_version = 1");
  const auto file = MapFile::open(path_);
  EXPECT_THAT(file.check(), IsEmpty());
  EXPECT_EQ(file.info().schemaVersion, 5);
  EXPECT_EQ(file.info().pieces, 1U) << "what there was is one piece, and the map";
  EXPECT_EQ(file.read().keyframes.size(), ward_.keyframes.size());
  EXPECT_EQ(file.read().objects.size(), ward_.objects.size());
  EXPECT_EQ(file.readLoops().at(0).inliers, 30);
  EXPECT_TRUE(file.readMemory().objects.empty());
  EXPECT_EQ(file.readViews().at(0).camera.depthNoise, core::DepthNoise{}) << "a Kinect's, as was taken for granted";
}

TEST_F(MapSchemaTest, OfAFileOfTheSecondVersionNoGroundIsKnown) {
  writeWard();
  runSql(kBackToTheFourth);
  runSql("DROP TABLE grounds; DROP TABLE depth_views; PRAGMA user_version = 2");
  const auto file = MapFile::open(path_);
  EXPECT_THAT(file.check(), IsEmpty());
  EXPECT_EQ(file.info().schemaVersion, 5);
  for (const auto& [id, keyframe] : file.read().keyframes) EXPECT_FALSE(keyframe.ground) << id;
}

TEST_F(MapSchemaTest, OfAFileOfTheThirdVersionNoDepthIsKnown) {
  writeWard();
  runSql(kBackToTheFourth);
  runSql("DROP TABLE depth_views; PRAGMA user_version = 3");
  const auto file = MapFile::open(path_);
  EXPECT_THAT(file.check(), IsEmpty());
  for (const auto& view : file.readViews()) EXPECT_EQ(view.depth, nullptr) << view.id;
}

TEST_F(MapSchemaTest, ZonesOfAFileOfTheFourthVersionAskForNothing) {
  writeWard();
  runSql(kBackToTheFourth);
  const auto file = MapFile::open(path_);
  EXPECT_THAT(file.check(), IsEmpty());
  ASSERT_EQ(file.read().zones.size(), ward_.zones.size());
  for (const auto& zone : file.read().zones) EXPECT_EQ(zone.type, mapping::ZoneType::Place) << zone.name;
}

TEST_F(MapSchemaTest, AnOlderFileCanBeReadUntouched) {
  writeWard();
  runSql(kBackToTheFourth);
  runSql("DROP TABLE grounds; DROP TABLE depth_views; PRAGMA user_version = 2");
  const auto bytes = [&] {
    std::ifstream in(path_, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string before = bytes();
  {
    const auto file = MapFile::open(path_, MapAccess::Untouched);
    EXPECT_EQ(file.info().schemaVersion, 5) << "in memory";
    EXPECT_EQ(file.read().objects.size(), ward_.objects.size());
  }
  EXPECT_TRUE(bytes() == before);
  static_cast<void>(MapFile::open(path_));
  EXPECT_FALSE(bytes() == before) << "else it is brought up to date";
}

TEST_F(MapSchemaTest, WhatIsHalfWrittenIsNotReadUntouched) {
  writeWard();
  std::ofstream(path_.string() + "-journal") << "left by a killed run";
  EXPECT_THAT(openingError(MapAccess::Untouched), HasSubstr("its writer was interrupted"));
}

TEST_F(MapSchemaTest, SaysThatANewerVersionWroteIt) {
  writeWard();
  runSql("PRAGMA user_version = 6");
  EXPECT_THAT(openingError(), HasSubstr("was written by a newer WardSLAM"));
}

}  // namespace
}  // namespace wardslam::storage
