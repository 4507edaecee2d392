#include "run_record.h"

#include <gmock/gmock.h>

#include "report/run_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::report {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

TEST(RunRecord, HoldsWhatARunLeft) {
  const RunFolderByHand folder;
  folder.write("pictures/1000.000000.jpg", "");
  folder.write("pictures/999.500000.jpg", "");
  folder.write("trajectory_piece_3.txt", "");
  const RunRecord run = readRun(folder.path());
  EXPECT_THAT(run.missing, IsEmpty());
  EXPECT_TRUE(run.isFinished);
  EXPECT_EQ(run.summary.at("frames"), 4);
  EXPECT_THAT(run.configuration, HasSubstr("min_inliers"));
  EXPECT_THAT(run.trajectory, SizeIs(3));
  EXPECT_THAT(run.frames, SizeIs(4));
  ASSERT_TRUE(run.map);
  EXPECT_THAT(run.map->objects, SizeIs(7));
  EXPECT_THAT(run.rooms.all, SizeIs(2));
  EXPECT_THAT(run.pictures,
              ElementsAre(folder.path() / "pictures/999.500000.jpg", folder.path() / "pictures/1000.000000.jpg"));
  EXPECT_EQ(run.unjoinedPieces, 1U);
  EXPECT_EQ(run.start_s(), 900.0);
  EXPECT_EQ(run.end_s(), 903.0);
}

TEST(RunRecord, TellsThatTheRunWasInterrupted) {
  const RunFolderByHand folder;
  folder.write("summary.json", R"({"interrupted": true})");
  EXPECT_THAT(readRun(folder.path()).missing, ElementsAre(StartsWith("The run was interrupted")));
  folder.write("summary.json", R"({"interrupted": false})");
  EXPECT_THAT(readRun(folder.path()).missing, IsEmpty());
}

TEST(RunRecord, OfAKilledRunHoldsWhatItHadWritten) {
  const RunFolderByHand folder;
  folder.kill();
  const RunRecord run = readRun(folder.path());
  EXPECT_FALSE(run.isFinished);
  EXPECT_THAT(run.trajectory, SizeIs(3));
  EXPECT_THAT(run.frames, SizeIs(4));  // the line that was cut off is none
  EXPECT_THAT(run.missing, ElementsAre(StartsWith("The run was killed or still goes on")));
}

TEST(RunRecord, TellsWhatIsNotThere) {
  const RunFolderByHand folder;
  for (const char* name : {"summary.json", "config.yaml", "frames.csv", "load.csv", "map.wardmap"}) folder.remove(name);
  EXPECT_THAT(readRun(folder.path()).missing,
              ElementsAre(StartsWith("summary.json is not there"), StartsWith("config.yaml is not there"),
                          StartsWith("frames.csv is not there"), StartsWith("load.csv is not there"),
                          StartsWith("map.wardmap is not there")));
}

TEST(RunRecord, TellsWhatIsDamagedWithoutNamingTheFolder) {
  const RunFolderByHand folder;
  folder.write("summary.json", "[1, 2");
  folder.write("trajectory.txt", "900 what\n");
  folder.write("frames.csv", "what\nwhat\n");
  folder.write("load.csv", "what\nwhat\n");
  folder.write("map.wardmap", "no map");
  const RunRecord run = readRun(folder.path());
  EXPECT_THAT(run.missing, ElementsAre(StartsWith("summary.json is damaged"), StartsWith("trajectory.txt"),
                                       StartsWith("frames.csv"), StartsWith("load.csv"), StartsWith("map.wardmap")));
  EXPECT_TRUE(run.summary.is_object());
  EXPECT_FALSE(run.map);
}

TEST(RunRecord, TakesAMapThatLiesElsewhere) {
  const RunFolderByHand folder;
  const test::TemporaryFolder elsewhere;
  std::filesystem::rename(folder.path() / "map.wardmap", elsewhere.path() / "ward.wardmap");
  EXPECT_TRUE(readRun(folder.path(), elsewhere.path() / "ward.wardmap").map);
}

TEST(RunRecord, OfWhatIsNoRunIsRefused) {
  const test::TemporaryFolder empty;
  const auto message = ThrowsMessage<core::InputError>(HasSubstr("holds nothing of a run"));
  EXPECT_THAT([&] { readRun(empty.path()); }, message);
  EXPECT_THAT([&] { readRun(empty.path() / "none"); }, ThrowsMessage<core::InputError>(HasSubstr("no such folder")));
}

}  // namespace
}  // namespace wardslam::report
