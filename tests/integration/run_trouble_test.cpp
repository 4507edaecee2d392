#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <thread>

#include "room_recording.h"
#include "run_fixture.h"

/// What goes wrong in the middle of a run, and what is on disk then.
namespace wardslam {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using Arguments = std::vector<std::string>;
using test::kImages;

class RunTrouble : public test::RunCommand {};

/// Two rawlogs behind one another are one.
void append(const fs::path& more, const fs::path& rawlog) {
  std::ofstream(rawlog, std::ios::binary | std::ios::app) << test::readText(more);
}

TEST_F(RunTrouble, ARawlogWhoseImagesChangeTheirSize) {
  const test::RoomRecording room(kImages);
  const fs::path rawlog = folder.path() / "room.rawlog";
  ASSERT_EQ(test::runProgram("tum2rawlog", {room.path(), "-o", rawlog}).exitCode, 0);
  const test::RoomRecording later(kImages, 0, 1100.0);
  for (int image = 0; image < kImages; ++image) {
    test::shrinkImage(later.color(image));
    test::shrinkImage(later.depth(image));
  }
  later.write("camera.yaml", "width: 160\nheight: 120\nfx: 131\nfy: 131\ncx: 79.5\ncy: 59.5\ndepth_factor: 5000\n");
  const fs::path small = folder.path() / "small.rawlog";
  ASSERT_EQ(test::runProgram("tum2rawlog", {later.path(), "-o", small}).exitCode, 0);
  append(small, rawlog);
  for (const Arguments& how :
       {Arguments{"--filter", "off"}, {"--filter", "geometric"}, {"--filter", "geometric", "--deterministic"}}) {
    fs::remove_all(out);
    const auto result = run(rawlog, how);
    expectError(result, 1, "the image has 160x120 pixels, those before it 320x240");
    EXPECT_THAT(result.err, HasSubstr("the first of 12 parts"));
    EXPECT_THAT(trajectory(), SizeIs(kImages));
    EXPECT_EQ(summary().at("damaged_input"), (nlohmann::json{{"sources.observation_unusable", kImages}}));
    EXPECT_TRUE(fs::exists(out / "objects.json"));
  }
}

TEST_F(RunTrouble, ARawlogWhoseStampsGoBack) {
  const test::RoomRecording room(kImages, 0, 1100.0);
  const test::RoomRecording earlier(kImages);
  const fs::path rawlog = folder.path() / "room.rawlog";
  const fs::path second = folder.path() / "second.rawlog";
  ASSERT_EQ(test::runProgram("tum2rawlog", {room.path(), "-o", rawlog}).exitCode, 0);
  ASSERT_EQ(test::runProgram("tum2rawlog", {earlier.path(), "-o", second}).exitCode, 0);
  append(second, rawlog);
  expectError(run(rawlog), 1, "s before the one that stands before it");
  EXPECT_THAT(trajectory(), SizeIs(kImages));
  EXPECT_EQ(summary().at("damaged_input"), (nlohmann::json{{"sources.stamp_goes_back", kImages}}));
}

TEST_F(RunTrouble, AnExceptionInALibrary) {
  const test::RoomRecording room(kImages);
  const auto config = folder.write("failing.yaml",
                                   "filters:\n  - class_name: wardslam::filters::SemanticDynamicFilter\n"
                                   "  - {class_name: 'third_party::FailingFilter', plugin: '" +
                                       std::string(WARDSLAM_TEST_PLUGIN) + "'}\n");
  for (const Arguments& how : {Arguments{}, {"--deterministic"}}) {
    fs::remove_all(out);
    Arguments arguments = {"--config", config, "--masks", room.masks()};
    arguments.insert(arguments.end(), how.begin(), how.end());
    expectError(run(room.path(), arguments), 1, "the run ended after 7 images");
    EXPECT_THAT(trajectory(), SizeIs(7));
    EXPECT_EQ(summary().at("frames"), 7);
    EXPECT_TRUE(fs::exists(out / "objects.json"));
    const auto check = test::runProgram("wardslam", {"map", "check", out / "map.wardmap"});
    EXPECT_EQ(check.exitCode, 0) << check.err;
    EXPECT_EQ(test::runProgram("wardslam", {"map", "info", out / "map.wardmap"}).exitCode, 0);
  }
}

TEST_F(RunTrouble, AnOldMapStaysWhereNothingIsTracked) {
  const test::RoomRecording room(kImages);
  ASSERT_EQ(run(room.path()).exitCode, 0);
  const std::string before = test::readText(out / "map.wardmap");
  const auto strict = folder.write("strict.yaml", "odometry: {min_initial_points: 10000}\nfilters: []\n");
  for (const Arguments& how : {Arguments{}, {"--deterministic"}}) {
    Arguments arguments = {"--config", strict};
    arguments.insert(arguments.end(), how.begin(), how.end());
    expectError(run(room.path(), arguments), 1, "no frame could be tracked");
    EXPECT_TRUE(test::readText(out / "map.wardmap") == before);
  }
  EXPECT_EQ(run(room.path(), {"--filter", "off", "--max-frames", "5"}).exitCode, 0);
  EXPECT_FALSE(test::readText(out / "map.wardmap") == before) << "where something is, the new map takes the place";
}

TEST_F(RunTrouble, ADiskThatIsFullForAMoment) {
  constexpr std::size_t kListed = 160;
  const test::RoomRecording room(kImages, kListed);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);  // the program inherits it: writing fails, and is no signal
  for (const Arguments& how :
       {Arguments{"--filter", "off", "--realtime"}, {"--filter", "off", "--realtime", "--deterministic"}}) {
    fs::remove_all(out);
    test::RunningProgram program("wardslam", argumentsOf(room.path(), how));
    const auto lines = [&] {
      const std::string text = test::readText(out / "trajectory_live.txt.partial");
      return std::count(text.begin(), text.end(), '\n');
    };
    const auto wait = [](const auto& until) {
      for (int i = 0; i < 3000 && !until(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    };
    wait([&] { return fs::exists(out / "trajectory_live.txt.partial") && lines() > 20; });
    program.limitFiles(1024);
    std::this_thread::sleep_for(std::chrono::seconds(3));
    program.limitFiles(std::nullopt);
    const auto result = program.wait();
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("trajectory_live.txt: cannot be written (is the disk full?)"));
    EXPECT_THAT(trajectory(), SizeIs(kListed));
    std::istringstream live(test::readText(out / "trajectory_live.txt"));
    EXPECT_EQ(std::count(std::istreambuf_iterator<char>(live), {}, '\n'), kListed + 1)
        << "a line of comment and all poses";
    EXPECT_TRUE(fs::exists(out / "objects.json"));
    EXPECT_EQ(summary().at("frames"), kListed);
  }
  std::signal(SIGXFSZ, handler);
}

}  // namespace
}  // namespace wardslam
