// The map a run leaves, also when it is killed at random moments. WARDSLAM_KILLS=100 in the environment: so often;
// WARDSLAM_KILL_RECORDING and WARDSLAM_KILL_MASKS: in this recording instead of a small room.

#include <gmock/gmock.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <random>
#include <thread>

#include "integration/cli_test_support.h"
#include "integration/room_recording.h"
#include "support/temporary_folder.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::test {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;

std::string environment(const char* name, const std::string& otherwise) {
  const char* const value = std::getenv(name);
  return value != nullptr ? value : otherwise;
}

TEST(FinishedRun, LeavesAMapOfWhatWasSeen) {
  const RoomRecording room;
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  ASSERT_EQ(runProgram("wardslam", {"run", room.path(), "--no-network", "--out", out.string()}).exitCode, 0);
  const auto file = storage::MapFile::open(out / "map.wardmap");
  EXPECT_THAT(file.check(), IsEmpty());
  EXPECT_GT(file.info().keyframes, 1U);
  EXPECT_EQ(file.readViews().size(), file.info().keyframes);
  EXPECT_GT(file.info().trackingPoints, 100U);
  EXPECT_GT(file.info().cloudPoints, 100U);
  EXPECT_FALSE(file.read().floorPlan.cells.empty());
  EXPECT_EQ(file.header().options, readText(out / "config.yaml"));
}

class KilledRun : public testing::TestWithParam<bool> {
 protected:
  static std::vector<std::string> arguments(const fs::path& out, const std::string& input, const std::string& masks) {
    std::vector<std::string> all = {"run", input, "--masks", masks, "--out", out.string()};
    if (GetParam()) all.emplace_back("--deterministic");
    return all;
  }

  /// Stamp (s) of the last whole line of a live trajectory; 0 while there is none.
  static double lastStamp_s(const fs::path& out) {
    const fs::path finished = out / "trajectory_live.txt";
    std::ifstream in(fs::exists(finished) ? finished : fs::path(finished.string() + ".partial"));
    double last_s = 0.0;
    for (std::string line; std::getline(in, line) && !in.eof();) {
      if (line.front() != '#') last_s = std::stod(line);
    }
    return last_s;
  }

  /// Stamps (s) of the keyframes a map holds, which must be sound.
  static std::vector<double> keyframeStamps_s(const fs::path& map) {
    const auto file = storage::MapFile::open(map);
    EXPECT_THAT(file.check(), IsEmpty());
    std::vector<double> stamps_s;
    for (const auto& view : file.readViews()) stamps_s.push_back(view.stamp_s);
    return stamps_s;
  }

  TemporaryFolder folder_;
};

/// By default tracking runs ahead of the map. Then what must be there cannot be told from outside, but all that is
/// there must be sound.
TEST_P(KilledRun, LeavesAMapThatOpensAndLacksNoKeyframeButTheLast) {
  const RoomRecording room(12, 150);
  const std::string input = environment("WARDSLAM_KILL_RECORDING", room.path());
  const std::string masks = environment("WARDSLAM_KILL_MASKS", room.masks());
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(runProgram("wardslam", arguments(folder_.path() / "whole", input, masks)).exitCode, 0);
  const std::chrono::duration<double> whole_s = std::chrono::steady_clock::now() - start;
  const auto expected_s = keyframeStamps_s(folder_.path() / "whole" / "map.wardmap");
  ASSERT_GT(expected_s.size(), 3U);

  std::mt19937 random(1);
  std::uniform_real_distribution<double> moment_s(0.0, whole_s.count());
  const int kills = std::stoi(environment("WARDSLAM_KILLS", "4"));
  for (int kill = 0; kill < kills; ++kill) {
    const fs::path out = folder_.path() / std::to_string(kill);
    RunningProgram program("wardslam", arguments(out, input, masks));
    std::this_thread::sleep_for(std::chrono::duration<double>(moment_s(random)));
    program.send(SIGKILL);
    (void)program.wait();
    const double last_s = lastStamp_s(out);
    if (!fs::exists(out / "map.wardmap")) {
      EXPECT_EQ(last_s, 0.0) << "tracked, but no map";
      continue;
    }
    const auto held_s = keyframeStamps_s(out / "map.wardmap");
    const auto due = std::count_if(expected_s.begin(), expected_s.end(), [&](double s) { return s <= last_s + 1e-6; });
    if (GetParam()) {
      EXPECT_GE(held_s.size() + 1, static_cast<std::size_t>(due)) << "killed at stamp " << last_s;
    }
    RecordProperty("kill_" + std::to_string(kill),
                   std::to_string(held_s.size()) + " keyframes of " + std::to_string(due));
    fs::remove_all(out);
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, KilledRun, testing::Bool(),
                         [](const auto& mode) { return mode.param ? "Deterministic" : "Free"; });

}  // namespace
}  // namespace wardslam::test
