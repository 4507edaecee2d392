#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "cli_test_support.h"
#include "room_recording.h"

namespace wardslam {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Arguments = std::vector<std::string>;

constexpr int kImages = 4;

class SweepCommand : public ::testing::Test {
 protected:
  [[nodiscard]] Arguments argumentsOf(const test::RoomRecording& recording, const Arguments& more) const {
    Arguments arguments = {"sweep", recording.path(), "--out", out, "--masks", recording.masks()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  [[nodiscard]] test::CommandResult sweep(const Arguments& more) const {
    return test::runProgram("wardslam", argumentsOf(room, more));
  }

  /// sweep.csv, a column of it by its heading.
  [[nodiscard]] std::vector<std::string> column(const std::string& heading) const {
    std::istringstream text(test::readText(out / "sweep.csv"));
    std::vector<std::vector<std::string>> lines;
    for (std::string line; std::getline(text, line);) {
      std::istringstream cells(line);
      lines.emplace_back();
      for (std::string cell; std::getline(cells, cell, ',');) lines.back().push_back(cell);
      lines.back().resize(std::max(lines.back().size(), lines.front().size()));  // the last may be empty
    }
    const auto& headings = lines.at(0);
    const auto index = std::find(headings.begin(), headings.end(), heading) - headings.begin();
    std::vector<std::string> values;
    for (std::size_t i = 1; i < lines.size(); ++i) values.push_back(lines[i].at(static_cast<std::size_t>(index)));
    return values;
  }
  [[nodiscard]] fs::path cell(const std::string& name) const { return out / "cells" / name; }

  void expectError(const Arguments& more, int exitCode, const std::string& part) const {
    const auto result = sweep(more);
    EXPECT_EQ(result.exitCode, exitCode);
    EXPECT_THAT(result.err, HasSubstr(part));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_FALSE(fs::exists(out / "cells")) << "nothing is run before all is known to be right";
  }

  test::TemporaryFolder folder;
  test::RoomRecording room{kImages};
  const fs::path out = folder.path() / "sweep";
};

TEST_F(SweepCommand, PutsTheResultsSideBySide) {
  const auto result =
      sweep({"--param", "filter.margin_px=0,40", "--param", "filter.n=5,7", "--param", "filter.delta=3,30",
             "--ground-truth", room.groundTruth(), "--dynamic-truth", room.masks()});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.err, test::noFloorIsSeen(6)) << "not a terminal: no progress line";
  EXPECT_EQ(result.out, test::readText(out / "sweep.md"));
  EXPECT_THAT(column("filter.margin_px"), ElementsAre("0", "0", "0", "0", "40", "40", "40", "40"));
  EXPECT_THAT(column("filter.delta"), ElementsAre("3", "30", "3", "30", "3", "30", "3", "30"));
  // A quarter of the picture moves; a margin of 40 columns makes it 120 of 320. 25 pixels cannot be more than 30.
  EXPECT_THAT(column("pixel precision"),
              ElementsAre("1.0000", "", "1.0000", "1.0000", "0.6667", "", "0.6667", "0.6667"));
  EXPECT_THAT(column("true positive pixels")[0], std::to_string(kImages * 80 * 240));
  EXPECT_THAT(column("false positive pixels")[4], std::to_string(kImages * 40 * 240));
  EXPECT_EQ(column("static key points kept")[0], "1.0000");
  EXPECT_LT(std::stod(column("static key points kept")[4]), 0.95);
  EXPECT_LT(std::stod(column("ATE [m]")[0]), 0.003);
  EXPECT_THAT(column("note")[1], HasSubstr("never be exceeded"));
  EXPECT_TRUE(fs::exists(cell("filter.margin_px=0,filter.n=5,filter.delta=3") / "trajectory.txt"));
}

TEST_F(SweepCommand, GoesOnWithWhatIsMissing) {
  ASSERT_EQ(sweep({"--param", "filter.n=5,7", "--param", "filter.delta=3"}).exitCode, 0);
  const fs::path kept = cell("filter.n=5,filter.delta=3") / "summary.json";
  const fs::path broken = cell("filter.n=7,filter.delta=3") / "summary.json";
  const auto when = fs::last_write_time(kept);
  fs::remove(broken);
  ASSERT_EQ(sweep({"--param", "filter.n=5,7,9", "--param", "filter.delta=3"}).exitCode, 0);
  EXPECT_EQ(fs::last_write_time(kept), when);
  EXPECT_TRUE(fs::exists(broken));
  EXPECT_THAT(column("coverage"), ElementsAre("1.0000", "1.0000", "1.0000"));

  ASSERT_EQ(sweep({"--param", "filter.n=5", "--param", "filter.delta=3", "--mode", "wait", "--config",
                   folder.write("other.yaml", "odometry: {min_inliers: 21}\n")})
                .exitCode,
            0);
  EXPECT_NE(fs::last_write_time(kept), when) << "another configuration is another run";
}

TEST_F(SweepCommand, AnInterruptionKeepsWhatIsFinished) {
  const test::RoomRecording endless(kImages, 20000);
  test::RunningProgram program("wardslam", argumentsOf(endless, {"--param", "odometry.min_inliers=20,21"}));
  const fs::path live = cell("odometry.min_inliers=20") / "trajectory_live.txt.partial";
  const auto begun = [&] { return fs::exists(live) && fs::file_size(live) > 1000; };
  for (int i = 0; i < 3000 && !begun(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ASSERT_TRUE(begun());
  program.send(SIGINT);
  EXPECT_EQ(program.wait().exitCode, 0);
  EXPECT_THAT(column("odometry.min_inliers"), ElementsAre("20", "21"));
  EXPECT_THAT(column("coverage"), ElementsAre("", "")) << "half a run is no result";
  EXPECT_FALSE(fs::exists(cell("odometry.min_inliers=21")));
}

TEST_F(SweepCommand, SaysWhatIsWrong) {
  expectError({"--param", "filter.nn=5"}, 1, "did you mean 'filter.n'");
  expectError({"--param", "odometry.min_inlier=5"}, 1, "did you mean 'odometry.min_inliers'");
  expectError({"--param", "odometry=5"}, 1, "no such parameter");
  expectError({"--param", "filter.n=many"}, 1, "filter.n=many");
  expectError({"--param", "filter.n=21,4"}, 1, "filter.n=4");
  expectError({"--param", "filter.n"}, 2, "filter.n=5,21,55");
  expectError({"--param", "filter.n=5", "--param", "filter.n=7"}, 2, "twice");
  expectError({}, 2, "--param");
}

TEST_F(SweepCommand, DoesNotMixRecordings) {
  ASSERT_EQ(sweep({"--param", "filter.n=15"}).exitCode, 0);
  const auto result = sweep({"--param", "filter.n=15", "--max-frames", "2"});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("another recording"));
}

}  // namespace
}  // namespace wardslam
