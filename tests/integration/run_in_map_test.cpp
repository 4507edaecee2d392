// Runs that go on in the map of an earlier one, and looking at what they made.

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <thread>

#include "integration/cli_test_support.h"
#include "integration/room_recording.h"
#include "support/temporary_folder.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

std::string secondLine(const fs::path& file) {
  std::istringstream text(readText(file));
  std::string line;
  std::getline(text, line);
  std::getline(text, line);
  return line;
}

class RunInMap : public testing::Test {
 protected:
  RunInMap() {
    const auto first = run({"--start-pose", "5 6 7 0 0 0 1", "--max-frames", "8"}, "first");
    EXPECT_EQ(first.exitCode, 0) << first.err;
  }

  CommandResult run(const std::vector<std::string>& more, const std::string& out) const {
    std::vector<std::string> arguments = {"run",   room_.path(), "--filter", "off", "--deterministic",
                                          "--out", path(out)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runProgram("wardslam", arguments);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  [[nodiscard]] std::string map() const { return path("first/map.wardmap"); }

  const RoomRecording room_;
  const TemporaryFolder folder_;
};

TEST_F(RunInMap, GrowsTheMap) {
  const auto before = storage::MapFile::open(map()).info();
  const auto result = run({"--map", map()}, "second");
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const auto file = storage::MapFile::open(map());
  EXPECT_GT(file.info().keyframes, before.keyframes);
  EXPECT_THAT(file.check(), IsEmpty());
  EXPECT_FALSE(fs::exists(path("second/map.wardmap"))) << "the map is where it was";
}

/// Without masks nothing is in the zones but keyframes.
TEST_F(RunInMap, WritesTheZonesItIsGiven) {
  std::ofstream(path("zones.yaml"))
      << "zones:\n- {name: everywhere, polygon: [[-99, -99], [99, -99], [99, 99], [-99, 99]]}\n";
  const auto result = run({"--map", map(), "--zones", path("zones.yaml")}, "second");
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const auto file = storage::MapFile::open(map());
  EXPECT_THAT(file.check(), IsEmpty());
  ASSERT_EQ(file.read().zones.size(), 1U);
  for (const auto& [id, keyframe] : file.read().keyframes) EXPECT_EQ(keyframe.zone, "everywhere") << id;
}

TEST_F(RunInMap, LeavesAMapItDoesNotRecogniseToTheByte) {
  const std::string before = readText(map());
  const RoomRecording elsewhere(8, 0, 1000.0, 99);
  const auto result = runProgram("wardslam", {"run", elsewhere.path().string(), "--filter", "off", "--deterministic",
                                              "--out", path("second"), "--map", map()});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("the map is as it was"));
  EXPECT_EQ(readText(map()), before);
  EXPECT_FALSE(fs::exists(map() + ".grown"));
}

TEST_F(RunInMap, KilledLeavesTheMapAsItWasAndASoundOneBesideIt) {
  const std::string before = readText(map());
  const RoomRecording longer(12, 600);
  RunningProgram program("wardslam", {"run", longer.path().string(), "--filter", "off", "--deterministic", "--out",
                                      path("second"), "--map", map()});
  const fs::path grown = map() + ".grown";
  const auto hasBegun = [&] {
    return fs::exists(grown) && fs::exists(path("second/trajectory_live.txt.partial")) &&
           fs::file_size(path("second/trajectory_live.txt.partial")) > 2000;
  };
  for (int i = 0; i < 6000 && !hasBegun(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  program.send(SIGKILL);
  (void)program.wait();
  EXPECT_EQ(readText(map()), before);
  ASSERT_TRUE(fs::exists(grown));
  EXPECT_THAT(storage::MapFile::open(grown).check(), IsEmpty());
  EXPECT_TRUE(storage::MapFile::open(grown).read().floorPlan.cells.empty()) << "the old one is not that of this map";
}

TEST_F(RunInMap, LocalisesInItsFrameWithoutChangingIt) {
  const std::string before = readText(map());
  const auto result = run({"--map", map(), "--localize"}, "second");
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(readText(map()), before);
  EXPECT_THAT(secondLine(path("second/trajectory.txt")), testing::MatchesRegex("1000.000000 (5.00|4.99).*"))
      << "where the first run began";
}

TEST_F(RunInMap, NeedsAMap) {
  EXPECT_EQ(run({"--localize"}, "second").exitCode, 2);
  const auto absent = run({"--map", path("absent.wardmap")}, "second");
  EXPECT_EQ(absent.exitCode, 2);
  EXPECT_THAT(absent.err, HasSubstr("absent.wardmap"));
  const auto foreign = run({"--map", room_.groundTruth().string()}, "second");
  EXPECT_EQ(foreign.exitCode, 1);
  EXPECT_THAT(foreign.err, HasSubstr("groundtruth.txt"));
}

TEST_F(RunInMap, ItsMapCanBeLookedAt) {
  const auto result = runProgram("wardslam", {"map", "view", map(), "--picture", path("map.png")});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_FALSE(cv::imread(path("map.png")).empty());
}

}  // namespace
}  // namespace wardslam::test
