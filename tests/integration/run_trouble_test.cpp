#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <thread>

#include "room_recording.h"
#include "run_fixture.h"
#include "support/small_disk.h"

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
  const auto strict = folder.write(
      "strict.yaml", "odometry: {min_initial_points: 10000, depth_alignment: {max_sigma: 0.001}}\nfilters: []\n");
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

TEST_F(RunTrouble, ADiskThatIsFullForGood) {
  const test::RoomRecording room(6);
  for (const std::size_t size_kb : {4, 40, 400}) {  // full at the first file, at the map, at the last files
    SCOPED_TRACE(size_kb);
    const test::SmallDisk disk(out, size_kb);
    if (!disk.isThere()) GTEST_SKIP() << "needs root, to mount a small disk";
    const auto result = run(room.path());
    EXPECT_EQ(result.exitCode, 1) << result.err;
    EXPECT_THAT(result.err, HasSubstr("disk full")) << result.err;
    if (fs::exists(out / "trajectory.txt")) {
      EXPECT_THAT(trajectory(), SizeIs(6)) << "all of it or nothing";
    }
    if (!fs::exists(out / "map.wardmap")) continue;
    const auto check = test::runProgram("wardslam", {"map", "check", out / "map.wardmap"});
    EXPECT_EQ(check.exitCode, 0) << check.err;
  }
}

TEST_F(RunTrouble, AFolderThatIsWriteProtected) {
  const test::RoomRecording room(kImages);
  const test::SmallDisk disk(out, 4096);
  if (!disk.isThere() || !disk.protect()) GTEST_SKIP() << "needs root, to mount a disk";
  expectError(run(room.path()), 1, out.string());
}

TEST_F(RunTrouble, AnOutputFolderThatVanishes) {
  constexpr std::size_t kListed = 100;
  const test::RoomRecording room(kImages, kListed);
  test::RunningProgram program("wardslam", argumentsOf(room.path(), {"--filter", "off", "--realtime"}));
  const fs::path live = out / "trajectory_live.txt.partial";
  const auto isUnderWay = [&] { return fs::exists(live) && fs::file_size(live) > 2000; };
  for (int i = 0; i < 3000 && !isUnderWay(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  fs::remove_all(out);
  const auto result = program.wait();
  EXPECT_EQ(result.exitCode, 1) << result.err;
  EXPECT_THAT(result.err, HasSubstr(out.string()));
}

TEST_F(RunTrouble, DepthThatStandsStill) {
  constexpr int kFrozen = 10, kMany = 36;
  const test::RoomRecording room(kMany);
  for (int image = kFrozen + 1; image < kMany; ++image) {
    fs::copy_file(room.depth(kFrozen), room.depth(image), fs::copy_options::overwrite_existing);
  }
  const auto result = run(room.path());
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("wardslam: depth has stood still since before 1000.375 s"));
  EXPECT_EQ(summary().at("events"), (nlohmann::json{{"sources.depth_still", 24}})) << "but for the first repeat";
  EXPECT_THAT(trajectory(), SizeIs(kMany));
}

TEST_F(RunTrouble, ACameraThatIsFrozen) {
  constexpr int kFrozen = 3, kMany = 45;
  const test::RoomRecording room(kMany);
  for (int image = kFrozen + 1; image < kMany; ++image) {
    fs::copy_file(room.color(kFrozen), room.color(image), fs::copy_options::overwrite_existing);
  }
  const auto result = run(room.path());
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("delivers one and the same image since 1000.094 s"));
  EXPECT_EQ(summary().at("events"), (nlohmann::json{{"sources.image_repeated", kMany - kFrozen - 1}}));
}

TEST_F(RunTrouble, DepthThatMeasuresNothing) {
  for (const int units : {0, 65535}) {
    const test::RoomRecording room(kImages);
    for (int image = 0; image < kImages; ++image) {
      cv::imwrite(room.depth(image).string(), cv::Mat(240, 320, CV_16UC1, cv::Scalar(units)));
    }
    fs::remove_all(out);
    expectError(run(room.path()), 1, "no frame could be tracked; does every image have texture and depth");
    EXPECT_EQ(summary().at("frames"), kImages);
  }
}

}  // namespace
}  // namespace wardslam
