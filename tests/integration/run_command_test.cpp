#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "cli_test_support.h"
#include "room_recording.h"
#include "run_fixture.h"

namespace wardslam {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::Each;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;
using Arguments = std::vector<std::string>;
using test::kImages;
using RunCommand = test::RunCommand;

TEST_F(RunCommand, WritesTrajectorySummaryAndConfiguration) {
  const test::RoomRecording room(kImages);
  const auto result = run(room.path());
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.err, test::noFloorIsSeen()) << "not a terminal: no progress line";

  const std::string number = " -?[0-9]+\\.[0-9]{9}";
  ASSERT_THAT(trajectory(), SizeIs(kImages));
  EXPECT_THAT(trajectory(),
              Each(MatchesRegex("1000\\.[0-9]{6}" + number + number + number + number + number + number + number)));

  const auto json = summary();
  EXPECT_EQ(json.at("frames"), kImages);
  EXPECT_EQ(json.at("frames_tracked"), kImages);
  EXPECT_EQ(json.at("coverage"), 1.0);
  EXPECT_EQ(json.at("lost_events"), 0);
  EXPECT_EQ(json.at("dynamic_keypoint_fraction"), 0.0);
  EXPECT_GT(json.at("fps").get<double>(), 0.0);
  EXPECT_GT(json.at("peak_rss_mb").get<double>(), 10.0);
  EXPECT_FALSE(json.at("interrupted").get<bool>());
  for (const char* stage :
       {"sources.build_frame", "features.extract", "filters.apply", "odometry.track", "pipeline.process"}) {
    const auto& times = json.at("stages").at(stage);
    EXPECT_EQ(times.at("calls"), kImages) << stage;
    EXPECT_GE(times.at("p95_ms").get<double>(), times.at("median_ms").get<double>()) << stage;
  }

  std::set<std::string> files;
  for (const auto& file : fs::directory_iterator(out)) files.insert(file.path().filename());
  EXPECT_EQ(files, (std::set<std::string>{"config.yaml", "frames.csv", "load.csv", "map.wardmap", "objects.json",
                                          "summary.json", "trajectory.txt", "trajectory_live.txt"}));
}

TEST_F(RunCommand, TheTrajectoryIsTheTruth) {
  const test::RoomRecording room(kImages);
  ASSERT_EQ(run(room.path(), {"--no-network", "--start-pose", "0 0 0 0 0 0 1"}).exitCode, 0);
  const auto result = test::runProgram("wardslam", {"eval", "--json", room.groundTruth(), out / "trajectory.txt"});
  const auto evaluation = nlohmann::json::parse(result.out);
  EXPECT_LT(evaluation.at("ate").at("rmse").get<double>(), 0.003);
  EXPECT_EQ(evaluation.at("ate").at("pairs"), kImages);
  EXPECT_EQ(evaluation.at("coverage"), 1.0);
  EXPECT_THAT(trajectory().front(), MatchesRegex("1000.000000( -?0.000000000){6} 1.000000000"))
      << "it starts where it is told";
}

TEST_F(RunCommand, ReadsARawlogToTheSamePoses) {
  const test::RoomRecording room(kImages);
  const fs::path rawlog = folder.path() / "room.rawlog";
  ASSERT_EQ(test::runProgram("tum2rawlog", {room.path(), "-o", rawlog}).exitCode, 0);
  ASSERT_EQ(run(rawlog, {"--filter", "off", "--deterministic"}).exitCode, 0);
  const auto fromRawlog = trajectory();
  ASSERT_THAT(fromRawlog, SizeIs(kImages));
  ASSERT_EQ(run(room.path(), {"--filter", "off", "--deterministic"}).exitCode, 0);
  EXPECT_EQ(trajectory(), fromRawlog);
}

TEST_F(RunCommand, StopsAfterSoManyFrames) {
  const test::RoomRecording room(kImages);
  EXPECT_EQ(run(room.path(), {"--filter", "off", "--max-frames", "5"}).exitCode, 0);
  EXPECT_THAT(trajectory(), SizeIs(5));
  EXPECT_EQ(summary().at("frames"), 5);
  expectError(run(room.path(), {"--max-frames", "0"}), 2, "--max-frames");
  expectError(run(room.path(), {"--max-frames", "-1"}), 2, "--max-frames");
}

TEST_F(RunCommand, MasksTakeKeypointsOut) {
  const test::RoomRecording room(kImages);
  const auto result = run(room.path(), {"--masks", room.masks()});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.err, test::noFloorIsSeen());
  // A quarter of the picture, and key points keep 16 px off its border: (80 + 3 - 16) of (320 - 32) columns.
  EXPECT_NEAR(summary().at("dynamic_keypoint_fraction").get<double>(), 67.0 / 288.0, 0.04);
  EXPECT_THAT(trajectory(), SizeIs(kImages));
  EXPECT_THAT(test::readText(out / "config.yaml"), HasSubstr("class_name: wardslam::filters::SemanticDynamicFilter"));

  ASSERT_EQ(run(room.path(), {"--masks", room.masks(), "--filter", "off"}).exitCode, 0);
  EXPECT_EQ(summary().at("dynamic_keypoint_fraction"), 0.0);
}

TEST_F(RunCommand, WithNothingSaidTheNetworkThatComesWithItSegments) {
  const test::RoomRecording room(4);
  const auto result = run(room.path(), {});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.err, AllOf(HasSubstr("--masks"), HasSubstr("--no-network"), HasSubstr("depth image")));
  EXPECT_TRUE(summary().at("events").empty()) << summary().at("events");
  const std::string config = test::readText(out / "config.yaml");
  EXPECT_THAT(config, AllOf(HasSubstr("type: depth "), HasSubstr("SemanticDynamicFilter")));

  const auto again = run(room.path(), {"--config", out / "config.yaml"});
  EXPECT_EQ(again.exitCode, 0);
  EXPECT_EQ(again.err, test::noFloorIsSeen()) << "a configuration says it";
  EXPECT_EQ(test::readText(out / "config.yaml"), config);
}

TEST_F(RunCommand, SaysWhereTheNetworkHadNoDepth) {
  const test::RoomRecording room(4);
  for (const int image : {1, 2}) {
    const std::string file = room.depth(image).string();
    ASSERT_TRUE(cv::imwrite(file, cv::Mat::zeros(cv::imread(file, cv::IMREAD_UNCHANGED).size(), CV_16UC1)));
  }
  const auto result = run(room.path(), {});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_THAT(result.err, HasSubstr("2 of 4 images had too little depth for the network"));
  EXPECT_EQ(summary().at("events").at("segmentation.no_depth"), 2);
}

TEST_F(RunCommand, WithoutANetworkGeometryAloneDecides) {
  const test::RoomRecording room(kImages);
  const auto result = run(room.path(), {"--no-network"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.err, test::noFloorIsSeen());
  const std::string told = test::readText(out / "config.yaml");

  const auto asked = run(room.path(), {"--filter", "geometric"});
  EXPECT_EQ(asked.exitCode, 0);
  EXPECT_EQ(asked.err, test::noFloorIsSeen());
  EXPECT_EQ(test::readText(out / "config.yaml"), told);
  EXPECT_THAT(told, AllOf(HasSubstr("GeometricMotionFilter"), Not(HasSubstr("SemanticDynamicFilter"))));
}

TEST_F(RunCommand, TheGeometricFilterKeepsItsParameters) {
  const test::RoomRecording room(kImages);
  const auto config =
      folder.write("my.yaml",
                   "filters:\n"
                   "  - class_name: wardslam::filters::SemanticDynamicFilter\n"
                   "  - {class_name: wardslam::filters::GeometricMotionFilter, params: {points: 99}}\n");
  EXPECT_EQ(run(room.path(), {"--config", config, "--masks", room.masks(), "--filter", "geometric"}).exitCode, 0);
  EXPECT_THAT(test::readText(out / "config.yaml"),
              AllOf(HasSubstr("points: 99"), Not(HasSubstr("SemanticDynamicFilter"))));
  EXPECT_LT(summary().at("dynamic_keypoint_fraction"), 0.02) << "nothing moves in the room";
}

TEST_F(RunCommand, TheEffectiveConfigurationRepeatsTheRun) {
  const test::RoomRecording room(kImages);
  const fs::path elsewhere = folder.path() / "elsewhere";
  for (const Arguments& choice :
       {Arguments{"--deterministic", "--masks", room.masks()}, {"--deterministic", "--filter", "off"}}) {
    ASSERT_EQ(run(room.path(), choice).exitCode, 0);
    const auto again =
        test::runProgram("wardslam", {"run", room.path(), "--out", elsewhere, "--config", out / "config.yaml"});
    EXPECT_EQ(again.exitCode, 0) << again.err;
    EXPECT_EQ(test::readText(elsewhere / "config.yaml"), test::readText(out / "config.yaml"));
    EXPECT_EQ(test::readText(elsewhere / "trajectory.txt"), test::readText(out / "trajectory.txt"));
  }
}

TEST_F(RunCommand, AConfigurationMayNameAFileBesideIt) {
  const test::RoomRecording room(kImages);
  folder.write("mine/knowledge.yaml", test::readText(fs::path(WARDSLAM_CONFIG_DIR) / "knowledge" / "hospital.yaml"));
  const auto config = folder.write("mine/config.yaml",
                                   "knowledge: {file: knowledge.yaml}\n"
                                   "segmentation: {type: recorded_masks, recorded_masks: {folder: " +
                                       room.masks().string() + "}}\n");
  ASSERT_EQ(run(room.path(), {"--config", config}).exitCode, 0);
  const auto again = test::runProgram(
      "wardslam", {"run", room.path(), "--out", folder.path() / "elsewhere", "--config", out / "config.yaml"});
  EXPECT_EQ(again.exitCode, 0) << again.err;
}

TEST_F(RunCommand, DeterministicRunsAreByteEqual) {
  const test::RoomRecording room(kImages);
  ASSERT_EQ(run(room.path(), {"--masks", room.masks(), "--deterministic"}).exitCode, 0);
  const std::string once = test::readText(out / "trajectory.txt");
  const std::string map = test::readText(out / "map.wardmap");
  ASSERT_EQ(run(room.path(), {"--masks", room.masks(), "--deterministic"}).exitCode, 0);
  EXPECT_EQ(test::readText(out / "trajectory.txt"), once);
  EXPECT_TRUE(test::readText(out / "map.wardmap") == map);
  EXPECT_TRUE(summary().at("deterministic").get<bool>());
}

TEST_F(RunCommand, MasksMayComeBehind) {
  const test::RoomRecording room(kImages);
  const Arguments propagate = {"--masks", room.masks(), "--mode", "propagate"};
  ASSERT_EQ(run(room.path(), propagate).exitCode, 0);
  EXPECT_THAT(test::readText(out / "config.yaml"), HasSubstr("mode: propagate"));
  EXPECT_NEAR(summary().at("dynamic_keypoint_fraction").get<double>(), 67.0 / 288.0, 0.06);

  const auto config = folder.write("late.yaml",
                                   "filters: [{class_name: 'wardslam::filters::SemanticDynamicFilter',"
                                   " params: {latency_frames: 3}}]\n");
  const Arguments late = {"--masks", room.masks(), "--mode", "propagate", "--deterministic", "--config", config};
  ASSERT_EQ(run(room.path(), late).exitCode, 0);
  const std::string once = test::readText(out / "trajectory.txt");
  EXPECT_EQ(summary().at("mask_age").at("median_frames"), 3);
  EXPECT_EQ(summary().at("mask_age").at("p95_frames"), 5);
  ASSERT_EQ(run(room.path(), late).exitCode, 0);
  EXPECT_EQ(test::readText(out / "trajectory.txt"), once);

  Arguments byChance = propagate;
  byChance.emplace_back("--deterministic");
  expectError(run(room.path(), byChance), 1, "latency_frames");
}

TEST_F(RunCommand, PlaysAsFastAsItWasRecorded) {
  const test::RoomRecording room(kImages);
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(run(room.path(), {"--filter", "off", "--realtime"}).exitCode, 0);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  const auto stamp_s = [](const std::string& pose) { return std::stod(pose.substr(0, pose.find(' '))); };
  EXPECT_GE(elapsed.count(), stamp_s(trajectory().back()) - stamp_s(trajectory().front()));
}

TEST_F(RunCommand, WritesPicturesWhereAsked) {
  const test::RoomRecording room(kImages);
  const auto names = [&] {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(out / "pictures")) found.push_back(entry.path().filename());
    std::sort(found.begin(), found.end());
    return found;
  };
  ASSERT_EQ(run(room.path(), {"--masks", room.masks(), "--pictures"}).exitCode, 0);
  EXPECT_THAT(names(), testing::ElementsAre("1000.000000.jpg", "1000.312500.jpg"));
  ASSERT_EQ(run(room.path(), {"--masks", room.masks(), "--pictures", "4"}).exitCode, 0);
  EXPECT_THAT(names(), testing::ElementsAre("1000.000000.jpg", "1000.125000.jpg", "1000.250000.jpg"));
  expectError(run(room.path(), {"--pictures", "0"}), 2, "--pictures");
}

TEST_F(RunCommand, AnInterruptionLeavesCompleteFiles) {
  const test::RoomRecording room(kImages, 20000);
  test::RunningProgram program("wardslam", argumentsOf(room.path(), {"--filter", "off"}));
  const auto enough = [&] {
    const std::string text = test::readText(out / "trajectory_live.txt.partial");
    return std::count(text.begin(), text.end(), '\n') > 20;
  };
  for (int i = 0; i < 3000 && !enough(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ASSERT_TRUE(enough()) << "poses are on disk as soon as they are known";
  program.send(SIGINT);
  const auto result = program.wait();
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.err, test::noFloorIsSeen());

  const auto json = summary();
  EXPECT_TRUE(json.at("interrupted").get<bool>());
  EXPECT_LT(json.at("frames"), 20000);
  EXPECT_THAT(trajectory(), SizeIs(json.at("frames_tracked").get<std::size_t>()));
  for (const auto& file : fs::directory_iterator(out)) EXPECT_NE(file.path().extension(), ".partial") << file;
}

TEST_F(RunCommand, ARealRecording) {
  const fs::path recording = fs::path(WARDSLAM_SHARED_DIR) / "data" / "rpy_walk";
  if (!fs::exists(recording)) GTEST_SKIP() << "not here: " << recording;
  const auto result = run(recording, {"--camera", fs::path(WARDSLAM_CONFIG_DIR) / "cameras" / "tum_freiburg1.yaml",
                                      "--masks", recording / "masks", "--max-frames", "20", "--pictures"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.err, test::noFloorIsSeen());
  EXPECT_THAT(trajectory(), SizeIs(20));
  EXPECT_TRUE(summary().at("events").empty()) << "every image has its mask: " << summary().at("events");
  EXPECT_EQ(std::distance(fs::directory_iterator(out / "pictures"), {}), 2);
}

TEST_F(RunCommand, RefusesWrongUsage) {
  const test::RoomRecording room(2);
  expectError(run(room.path(), {"--filter", "on", "--no-network"}), 2, "--filter on needs masks");
  expectError(run(room.path(), {"--masks", "a", "--no-network"}), 2, "--no-network");
  expectError(run(room.path(), {"--filter", "perhaps"}), 2, "perhaps");
  expectError(run(room.path(), {"--mode", "guess"}), 2, "--mode");
  expectError(run(room.path(), {"--filter", "off", "--mode", "propagate"}), 2, "--mode");
  expectError(run(room.path(), {"--masks", "a", "--model", "b"}), 2, "--model");
  expectError(run(room.path(), {"--maxframes", "3"}), 2, "unknown option '--maxframes'; did you mean '--max-frames'?");
  expectError(run(room.path(), {"--maxframes=3"}), 2, "unknown option '--maxframes'; did you mean '--max-frames'?");
  expectError(run(room.path(), {"third"}), 2, "unexpected argument 'third'");
  expectError(test::runProgram("wardslam", {"run", "--out", out}), 2, "INPUT is required");
  expectError(test::runProgram("wardslam", {"run", room.path()}), 2, "--out is required");
  EXPECT_FALSE(fs::exists(out)) << "nothing was begun";
}

// Bad input: one sentence that names the place, and the results of the good part.

TEST_F(RunCommand, AMissingFolder) {
  expectError(run(folder.path() / "none"), 1, "none: no such file or folder");
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(RunCommand, AnOutputFolderThatCannotBeMade) {
  const test::RoomRecording room(2);
  const auto file = folder.write("file", "");
  expectError(test::runProgram("wardslam", {"run", room.path(), "--out", file / "results", "--filter", "off"}), 1,
              "file/results: cannot be made");
}

TEST_F(RunCommand, AnEmptyList) {
  const test::RoomRecording room(2);
  room.write("rgb.txt", "# color images\n");
  expectError(run(room.path()), 1, "rgb.txt: lists no image");
}

TEST_F(RunCommand, AListedImageThatIsMissing) {
  const test::RoomRecording room(kImages);
  fs::remove(room.color(4));
  expectError(run(room.path()), 1, "rgb.txt:5: " + room.color(4).string() + " is missing");
  expectTheRest(kImages - 1, "sources.image_missing");
}

TEST_F(RunCommand, AnImageThatIsCutOff) {
  for (const bool isColor : {true, false}) {
    const test::RoomRecording room(kImages);
    const fs::path image = isColor ? room.color(7) : room.depth(7);
    test::cutOff(image, 0.6);
    expectError(run(room.path()), 1, "rgb.txt:8: " + image.string() + " is cut off");
    expectTheRest(kImages - 1, "sources.image_truncated");
  }
}

TEST_F(RunCommand, DepthOfAnotherSize) {
  const test::RoomRecording room(kImages);
  test::shrinkImage(room.depth(3));
  expectError(run(room.path()), 1, "depth/3.png has 160x120 pixels but its colour image 320x240");
  expectTheRest(kImages - 1, "sources.depth_size");
}

TEST_F(RunCommand, ManyKindsOfDamageAreOneSentence) {
  const test::RoomRecording room(kImages);
  fs::remove(room.color(4));
  test::cutOff(room.color(7), 0.6);
  test::shrinkImage(room.depth(9));
  test::shrinkImage(room.depth(10));
  const auto result = run(room.path());
  expectError(result, 1, "4.png is missing");
  EXPECT_THAT(result.err, HasSubstr("the first of 4 parts"));
  EXPECT_EQ(summary().at("damaged_input"),
            (nlohmann::json{{"sources.image_missing", 1}, {"sources.image_truncated", 1}, {"sources.depth_size", 2}}));
}

TEST_F(RunCommand, ARawlogThatIsCutOff) {
  const test::RoomRecording room(kImages);
  const fs::path rawlog = folder.path() / "room.rawlog";
  ASSERT_EQ(test::runProgram("tum2rawlog", {room.path(), "-o", rawlog}).exitCode, 0);
  test::cutOff(rawlog, 0.5);
  expectError(run(rawlog), 1, "room.rawlog: is cut off or damaged");
  const std::size_t frames = trajectory().size();
  EXPECT_GT(frames, 3U);
  EXPECT_LT(frames, 9U);
  expectTheRest(frames, "sources.rawlog_truncated");
}

TEST_F(RunCommand, ACameraThatIsNotKnown) {
  const test::RoomRecording room(2);
  fs::remove(room.path() / "camera.yaml");
  expectError(run(room.path()), 1, "tum_freiburg3.yaml");
  const auto result = run(
      room.path(), {"--filter", "off", "--camera", fs::path(WARDSLAM_CONFIG_DIR) / "cameras" / "tum_freiburg3.yaml"});
  expectError(result, 1, "rgb/0.png has 320x240 pixels but the camera 640x480");
}

TEST_F(RunCommand, AnInputThatIsNoRecording) {
  expectError(run(folder.write("letter.rawlog", "Dear Sir or Madam\n")), 1, "letter.rawlog: is empty or not a rawlog");
  expectError(run(folder.write("empty.rawlog", "")), 1, "empty.rawlog: is empty or not a rawlog");
  fs::create_directory(folder.path() / "void");
  expectError(run(folder.path() / "void"), 1, "void: there are neither lists of images (rgb.txt");
}

TEST_F(RunCommand, AMisspeltKey) {
  const test::RoomRecording room(2);
  const auto config = folder.write("my.yaml", "features:\n  key_points: 500\nodometry:\n  min_inlier: 10\n");
  expectError(run(room.path(), {"--config", config}), 1,
              "my.yaml:4: 'odometry.min_inlier': unknown key; did you mean 'min_inliers'?");
  const auto filter = folder.write("filter.yaml",
                                   "filters:\n  - class_name: wardslam::filters::SemanticDynamicFilter\n"
                                   "    params:\n      detla: 10\n");
  expectError(run(room.path(), {"--config", filter, "--masks", room.masks()}), 1,
              "filter.yaml:4: 'filters[0].params.detla': unknown key; did you mean 'delta'?");
  expectError(run(room.path(), {"--config", folder.path() / "none.yaml"}), 1, "none.yaml: cannot be opened");
  const auto camera = folder.write("camera.yaml", "width: 320\nheigth: 240\n");
  expectError(run(room.path(), {"--filter", "off", "--camera", camera}), 1,
              "camera.yaml:2: 'heigth': unknown key; did you mean 'height'?");
}

TEST_F(RunCommand, ANetworkThatCannotBeLoaded) {
  const test::RoomRecording room(2);
  expectError(run(room.path(), {"--model", folder.write("net.onnx", "this is no network")}), 1,
              "net.onnx: not a complete ONNX file");
  expectError(run(room.path(), {"--model", folder.path() / "none.onnx"}), 1, "none.onnx: cannot be opened");
}

TEST_F(RunCommand, MasksThatMatchNoFrame) {
  const test::RoomRecording room(2, 50);
  const fs::path masks = folder.path() / "masks";
  fs::create_directory(masks);
  fs::copy(room.masks() / "1000.000000.png", masks / "5.000000.png");
  expectError(run(room.path(), {"--masks", masks}), 1, "masks: no mask within 5 ms of the first image (1000.000000)");
  EXPECT_THAT(trajectory(), Not(IsEmpty()));
  EXPECT_GE(summary().at("frames"), 1);

  expectError(run(room.path(), {"--masks", masks, "--max-frames", "3"}), 1, "masks: no mask within 5 ms");
  EXPECT_THAT(trajectory(), SizeIs(3));

  fs::create_directory(folder.path() / "empty");
  expectError(run(room.path(), {"--masks", folder.path() / "empty"}), 1, "empty: holds no .png file");
}

TEST_F(RunCommand, APictureOfNothingIsNotTracked) {
  const test::RoomRecording room(2, 4);
  const auto blank = folder.write(
      "camera.yaml", "width: 320\nheight: 240\nfx: 262.5\nfy: 262.5\ncx: 159.5\ncy: 119.5\ndepth_factor: 5000\n");
  const auto strict = folder.write(
      "strict.yaml", "odometry: {min_initial_points: 10000, depth_alignment: {max_sigma: 0.001}}\nfilters: []\n");
  expectError(run(room.path(), {"--camera", blank, "--config", strict}), 1, "no frame could be tracked");
  EXPECT_EQ(summary().at("frames_tracked"), 0);
  EXPECT_EQ(summary().at("frames"), 4);
}

}  // namespace
}  // namespace wardslam
