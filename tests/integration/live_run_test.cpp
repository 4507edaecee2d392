#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "cli_test_support.h"
#include "support/temporary_folder.h"
#include "virtual_camera.h"

namespace wardslam {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

#ifdef WARDSLAM_VIRTUAL_OPENNI2

/// `wardslam run openni2.ini` with MRPT's COpenNI2Sensor, OpenNI2 itself and a driver for tests.
class LiveRun : public ::testing::Test {
 protected:
  LiveRun() {
    folder.write("quick.yaml",
                 "sources:\n  live:\n    open_timeout: 5\n    silence_timeout: 1\n    first_pause: 0.1\n"
                 "    longest_pause: 0.2\n");
  }

  [[nodiscard]] std::vector<std::string> arguments(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"run",      WARDSLAM_CONFIG_DIR "/sensors/openni2.ini",
                                      "--out",    out,
                                      "--config", folder.path() / "quick.yaml",
                                      "--filter", "off"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  [[nodiscard]] test::CommandResult run(const std::vector<std::string>& more) const {
    return test::runProgram("wardslam", arguments(more));
  }
  void waitForPoses() const {
    for (int i = 0; i < 1000 && test::readText(out / "trajectory_live.txt.partial").size() < 500; ++i) {
      std::this_thread::sleep_for(10ms);
    }
  }
  [[nodiscard]] nlohmann::json summary() const { return nlohmann::json::parse(test::readText(out / "summary.json")); }

  test::VirtualCamera camera;
  test::TemporaryFolder folder;
  fs::path out = folder.path() / "out";
};

TEST_F(LiveRun, TracksACamera) {
  const auto result = run({"--max-frames", "30"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(summary()["frames"], 30);
  EXPECT_EQ(summary()["frames_tracked"], 30);
  const auto live = summary()["live"];
  EXPECT_EQ(live["frames_processed"], 30);
  EXPECT_EQ(live["frames_in"], 30 + live["frames_skipped"].get<int>());
  EXPECT_EQ(live["frames_unusable"], 0);
  EXPECT_EQ(live["reconnects"], 0);
  EXPECT_GT(live["latency"]["median_ms"], 0.0);
  EXPECT_LE(live["latency"]["median_ms"], live["latency"]["p95_ms"]);
  EXPECT_THAT(result.err, MatchesRegex("wardslam: [0-9]+ images came, 30 were worked on, [^\n]*\n"
                                       "(wardslam: not everything is in the map: [^\n]*\n)?"
                                       "wardslam: no image shows the floor: [^\n]*\n"));
}

TEST_F(LiveRun, GoesOnWhenTheCameraIsUnpluggedAndBack) {
  test::RunningProgram program("wardslam", arguments({}));
  waitForPoses();
  camera.set("unplugged");
  std::this_thread::sleep_for(2000ms);  // longer than an image may stay away
  const auto posesBefore = test::readText(out / "trajectory_live.txt.partial").size();
  camera.set("plugged");
  for (int i = 0; i < 1000 && test::readText(out / "trajectory_live.txt.partial").size() < posesBefore + 500; ++i) {
    std::this_thread::sleep_for(10ms);
  }
  program.send(SIGINT);
  const auto result = program.wait();
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(summary()["live"]["reconnects"], 1);
  EXPECT_EQ(summary()["frames"], summary()["frames_tracked"]);
  EXPECT_THAT(result.err, AllOf(HasSubstr("the camera is unplugged or its driver hangs; trying to open it again\n"),
                                HasSubstr("the camera is back after ")));
}

TEST_F(LiveRun, EndsWithASentenceWhenTheCameraStaysAway) {
  folder.write("quick.yaml", "sources:\n  live:\n    silence_timeout: 1\n    first_pause: 0.1\n    max_attempts: 1\n");
  test::RunningProgram program("wardslam", arguments({}));
  waitForPoses();
  camera.set("unplugged");
  const auto result = program.wait();
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("no OpenNI2 camera was found"));
  EXPECT_THAT(result.err, EndsWith("(after 1 attempts to open it again)\n"));
  EXPECT_GT(summary()["frames_tracked"], 0);  // what was seen until then is written
}

TEST_F(LiveRun, SaysWhenThereIsNoCamera) {
  camera.set("unplugged");
  const auto result = run({});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, MatchesRegex("wardslam: .*openni2.ini: \\[OPENNI2\\]: no OpenNI2 camera was found [^\n]*\n"));
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(LiveRun, SaysWhenTheCameraHasNoInfraredStream) {
  camera.set("plugged", "infrared = absent\n");  // COpenNI2Sensor would wait for ever
  folder.write("quick.yaml", "sources:\n  live:\n    open_timeout: 2.5\n");
  const auto result = run({});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err,
              HasSubstr("the camera sent no image within 2.5 s; COpenNI2Sensor waits for ever where a camera "
                        "has no infrared stream"));
}

TEST_F(LiveRun, SaysWhenTheCameraHasAnotherMode) {
  camera.set("plugged", "mode_width = 320\nmode_height = 240\nwidth = 320\nheight = 240\n");
  const auto result = run({});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("has it this width, height and fps?"));
}

TEST_F(LiveRun, SaysWhenImagesHaveAnotherSizeThanTheMode) {
  camera.set("plugged", "width = 320\nheight = 240\n");
  const auto result = run({});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("every observation for 1 s has a colour image of 320x240 pixels, but its camera "
                                    "has 640x480"));
}

#else

TEST(LiveRun, NeedsOpenNi2) {
  GTEST_SKIP() << "built without the virtual camera: it needs the Debian package libopenni2-dev";
}

#endif

TEST(LiveRunArguments, MustFitTheInput) {
  const auto expectUsage = [](const std::vector<std::string>& arguments, const std::string& part) {
    const auto result = test::runProgram("wardslam", arguments);
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_THAT(result.err, HasSubstr(part));
  };
  expectUsage({"run", "ward.rawlog", "--out", "o", "--seconds", "5"}, "are for cameras: INPUT must be an .ini file");
  expectUsage({"run", "camera.ini", "--out", "o", "--realtime"}, "are for recordings, not for a camera");
  expectUsage({"run", "camera.ini", "--out", "o", "--masks", "m"}, "are for recordings, not for a camera");
  expectUsage({"sweep", "camera.ini", "--out", "o", "--param", "features.key_points=500,1000"},
              "a sweep needs a recording");
}

}  // namespace
}  // namespace wardslam
