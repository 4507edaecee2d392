#include "wardslam/pipeline/load_table.h"

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "support/textured_room_scan.h"
#include "wardslam/core/errors.h"

namespace wardslam::pipeline {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr const char* kHeadings =
    "timestamp,frames,frame_ms,keyframes,graph_ms,mapping_ms,storage_ms,apply_ms,waiting,memory_mb,open_files\n";

SlamOptions withoutFilters() {
  SlamOptions options;
  options.deterministic = true;
  options.filters = SlamOptions::noFilters();
  return options;
}

/// The same image at these seconds, the first of them a keyframe.
void observeAt(const std::vector<double>& stamps_s, SlamSystem& slam) {
  const test::TexturedRoom room;
  for (const double stamp_s : stamps_s) {
    const auto scan = test::observe(room, 0);
    scan->timestamp = core::toMrptTime(stamp_s);
    slam.process(scan);
  }
}

TEST(LoadTable, HasALineForEverySecondAsItGoes) {
  const test::TemporaryFolder folder;
  SlamSystem slam(withoutFilters());
  LoadTable table(folder.path() / "load.csv", slam);
  table.setStampOrigin(1000.0);
  slam.addObserver(table);
  observeAt({1000.0, 1000.5, 1001.0, 1001.5, 1002.25}, slam);
  const auto soFar = readLoadTable(folder.path() / "load.csv.partial");
  ASSERT_EQ(soFar.size(), 2U);
  EXPECT_DOUBLE_EQ(soFar[0].stamp_s, 1.0);
  EXPECT_DOUBLE_EQ(soFar[1].stamp_s, 2.25);
  EXPECT_EQ(soFar[0].frames, 3U);
  EXPECT_EQ(soFar[1].frames, 2U);
  EXPECT_EQ(soFar[0].keyframes, 1U);
  EXPECT_EQ(soFar[1].keyframes, 0U);
  table.finish();
  EXPECT_EQ(readLoadTable(folder.path() / "load.csv").size(), 2U);
}

TEST(LoadTable, TellsWhatWasSpentSinceTheLineBefore) {
  const test::TemporaryFolder folder;
  SlamSystem slam(withoutFilters());
  LoadTable table(folder.path() / "load.csv", slam);
  slam.addObserver(table);
  observeAt({1000.0, 1001.0, 1002.0, 1003.0}, slam);
  table.finish();
  const auto rows = readLoadTable(folder.path() / "load.csv");
  ASSERT_EQ(rows.size(), 3U);
  double frames_ms = 0.0;
  double map_ms = 0.0;
  double apply_ms = 0.0;
  for (const LoadRow& row : rows) {
    frames_ms += row.frame_ms;
    map_ms += row.map_ms();
    apply_ms += row.apply_ms;
    EXPECT_GT(row.memory_mb, 1.0);
    EXPECT_GE(row.openFiles, 3U) << "the three every program has";
    EXPECT_EQ(row.waiting, 0U) << "a deterministic run waits for nothing";
  }
  const auto totals = slam.profiler().totals();
  EXPECT_GT(frames_ms, 0.0);
  EXPECT_LE(frames_ms, totals.at("pipeline.process").total_ms + 0.01 * 3);
  double ofMap_ms = 0.0;
  for (const char* step : {"graph.insert", "mapping.add", "mapping.ground", "mapping.correct"}) {
    if (totals.count(step) > 0) ofMap_ms += totals.at(step).total_ms;
  }
  EXPECT_NEAR(map_ms, ofMap_ms, 0.01 * 3 + 0.2) << "the last frame is in it but for what follows the table";
  EXPECT_NEAR(apply_ms, totals.at("odometry.apply").total_ms, 0.01 * 3 + 0.02);
}

TEST(LoadTable, IsReadWithoutALineThatIsCutOff) {
  const test::TemporaryFolder folder;
  const auto rows = readLoadTable(
      folder.write("load.csv", std::string(kHeadings) + "1.0,30,25.5,2,60,20.25,10,0.5,3,101.5,12\n2.0,30,2"));
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_DOUBLE_EQ(rows[0].frame_ms, 25.5);
  EXPECT_EQ(rows[0].keyframes, 2U);
  EXPECT_DOUBLE_EQ(rows[0].graph_ms, 60.0);
  EXPECT_DOUBLE_EQ(rows[0].mapping_ms, 20.25);
  EXPECT_DOUBLE_EQ(rows[0].storage_ms, 10.0);
  EXPECT_DOUBLE_EQ(rows[0].map_ms(), 90.25);
  EXPECT_DOUBLE_EQ(rows[0].apply_ms, 0.5);
  EXPECT_EQ(rows[0].waiting, 3U);
  EXPECT_DOUBLE_EQ(rows[0].memory_mb, 101.5);
  EXPECT_EQ(rows[0].openFiles, 12U);
}

TEST(LoadTable, NamesTheLineThatIsNone) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("load.csv", std::string(kHeadings) + "1.0,30,fast,2,60,20.25,10,0.5,3,101.5,12\n" +
                                                 "2.0,30,25.5,2,60,20.25,10,0.5,3,101.5,12\n");
  EXPECT_THAT([&] { (void)readLoadTable(file); }, ThrowsMessage<core::InputError>(HasSubstr("load.csv:2: ")));
}

}  // namespace
}  // namespace wardslam::pipeline
