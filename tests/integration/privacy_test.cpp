// What the files of a run hold of people (docs/privacy.md).

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <vector>

#include "integration/room_recording.h"
#include "integration/run_fixture.h"
#include "wardslam/features/orb_extractor.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;
using Descriptor = std::array<std::uint8_t, 32>;

constexpr double kStart_s = 1305031102.25;

Descriptor descriptorIn(const cv::Mat& descriptors, int row) {
  Descriptor descriptor{};
  std::copy_n(descriptors.ptr<std::uint8_t>(row), descriptor.size(), descriptor.begin());
  return descriptor;
}

/// A TUM folder's masks, and its images by stamp.
struct Recording {
  fs::path folder;
  fs::path masks;

  [[nodiscard]] cv::Mat personMask(double stamp_s) const {
    const cv::Mat ids = cv::imread((masks / nameOf(stamp_s)).string(), cv::IMREAD_UNCHANGED);
    EXPECT_FALSE(ids.empty()) << nameOf(stamp_s);
    return ids == 1;
  }
  [[nodiscard]] cv::Mat gray(double stamp_s) const {
    std::ifstream list(folder / "rgb.txt");
    for (std::string line; std::getline(list, line);) {
      if (line.empty() || line.front() == '#' || std::abs(std::stod(line) - stamp_s) > 1e-4) continue;
      return cv::imread((folder / line.substr(line.find(' ') + 1)).string(), cv::IMREAD_GRAYSCALE);
    }
    return {};
  }
  static std::string nameOf(double stamp_s) {
    char name[32];
    std::snprintf(name, sizeof name, "%.6f.png", stamp_s);
    return name;
  }
};

/// Key points that lie on people, and those of the file that look like one of them.
struct Looks {
  std::size_t ofPeople = 0;
  std::size_t found = 0;
  std::size_t stored = 0;
};

bool isOn(const cv::Mat& mask, const cv::Point2f& px) {
  return mask.at<std::uint8_t>(cvRound(px.y), cvRound(px.x)) != 0;
}

/// Of every keyframe in the file: no key point lies on somebody. Of every image of a keyframe: what its people look
/// like is not in the file.
Looks lookForPeople(const fs::path& map, const Recording& recording) {
  Looks looks;
  std::set<Descriptor> stored;
  std::vector<double> stamps_s;
  for (const auto& view : storage::MapFile::open(map).readViews()) {
    stamps_s.push_back(view.stamp_s);
    const cv::Mat people = recording.personMask(view.stamp_s);
    for (const auto& keypoint : view.features.keypoints) {
      EXPECT_FALSE(isOn(people, keypoint.raw_px)) << "keyframe " << view.id << ", " << keypoint.raw_px;
    }
    for (int i = 0; i < view.features.descriptors.rows; ++i) stored.insert(descriptorIn(view.features.descriptors, i));
  }
  features::OrbExtractor extractor{features::OrbOptions{}};
  for (const double stamp_s : stamps_s) {
    core::Frame frame;
    frame.gray = recording.gray(stamp_s);
    frame.depth_m = cv::Mat(frame.gray.size(), CV_32FC1, cv::Scalar(1));
    frame.camera.width_px = frame.gray.cols;
    frame.camera.height_px = frame.gray.rows;
    extractor.extract(frame);
    const cv::Mat people = recording.personMask(stamp_s);
    for (std::size_t i = 0; i < frame.features.size(); ++i) {
      if (!isOn(people, frame.features.keypoints[i].raw_px)) continue;
      ++looks.ofPeople;
      looks.found += stored.count(descriptorIn(frame.features.descriptors, static_cast<int>(i)));
    }
  }
  looks.stored = stored.size();
  return looks;
}

class Privacy : public RunCommand {
 protected:
  /// Names of folders in any file of the run, but for config.yaml, and what looks like a stamp of the recording.
  static void expectNothingIn(const fs::path& results, const std::string& text, const std::set<std::string>& except) {
    for (const auto& entry : fs::recursive_directory_iterator(results)) {
      EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr(text)));
      if (!entry.is_regular_file() || except.count(entry.path().filename().string()) > 0) continue;
      EXPECT_EQ(readText(entry.path()).find(text), std::string::npos) << entry.path() << " holds " << text;
    }
  }
};

TEST_F(Privacy, NothingOfHowPeopleLookIsInTheMap) {
  const RoomRecording room(kImages);
  ASSERT_EQ(run(room.path(), {"--masks", room.masks()}).exitCode, 0);
  const Looks looks = lookForPeople(out / "map.wardmap", {room.path(), room.masks()});
  EXPECT_GT(looks.ofPeople, 100U);
  EXPECT_GT(looks.stored, 100U);
  EXPECT_EQ(looks.found, 0U);
}

TEST_F(Privacy, NothingOfHowPeopleWhoWalkByLookIsInTheMap) {
  const fs::path recording = fs::path(WARDSLAM_SHARED_DIR) / "data" / "ward_walking";
  if (!fs::exists(recording)) GTEST_SKIP() << "not here: " << recording;
  ASSERT_EQ(run(recording, {"--masks", recording / "masks", "--max-frames", "40"}).exitCode, 0);
  const Looks looks = lookForPeople(out / "map.wardmap", {recording, recording / "masks"});
  EXPECT_GT(looks.ofPeople, 100U);
  EXPECT_EQ(looks.found, 0U);
}

TEST_F(Privacy, OnlyKeyPointsOfPointsThatLastedAreInTheMap) {
  const RoomRecording room(kImages);
  ASSERT_EQ(run(room.path(), {"--masks", room.masks()}).exitCode, 0);
  const auto file = storage::MapFile::open(out / "map.wardmap");
  EXPECT_THAT(file.check(), IsEmpty());
  for (const auto& view : file.readViews()) {
    std::set<std::size_t> sighted;
    for (const auto& sighting : view.sightings) sighted.insert(sighting.keypoint);
    EXPECT_EQ(sighted.size(), view.features.size()) << "keyframe " << view.id;
  }
}

TEST_F(Privacy, NoFileButTheConfigurationNamesAFolder) {
  const RoomRecording room(kImages);
  ASSERT_EQ(run(room.path(), {"--masks", room.masks()}).exitCode, 0);
  expectNothingIn(out, room.path().string(), {"config.yaml"});
  EXPECT_THAT(storage::MapFile::open(out / "map.wardmap").header().options, HasSubstr("folder: \"masks\""));
}

TEST_F(Privacy, APrivateRunTellsNoTimeAndNoFolder) {
  const RoomRecording room(kImages, 0, kStart_s);
  ASSERT_EQ(run(room.path(), {"--masks", room.masks(), "--deterministic"}).exitCode, 0);
  const auto open = trajectory();
  ASSERT_EQ(run(room.path(), {"--masks", room.masks(), "--deterministic", "--private", "--pictures"}).exitCode, 0);
  const auto hidden = trajectory();
  ASSERT_EQ(hidden.size(), open.size());
  EXPECT_THAT(hidden.front(), StartsWith("0.000000 "));
  for (std::size_t i = 0; i < open.size(); ++i) {
    EXPECT_EQ(open[i].substr(open[i].find(' ')), hidden[i].substr(hidden[i].find(' '))) << "the same poses";
    EXPECT_NEAR(std::stod(open[i]) - kStart_s, std::stod(hidden[i]), 1e-5);
  }
  expectNothingIn(out, "13050311", {});
  expectNothingIn(out, room.path().string(), {});
  EXPECT_TRUE(fs::exists(out / "pictures" / "0.312500.jpg"));
  const auto file = storage::MapFile::open(out / "map.wardmap");
  EXPECT_LT(file.info().lastStamp_s, 10.0);
  for (const auto& [id, object] : file.read().objects) EXPECT_LT(object.lastSeen_s, 10.0);
  for (const auto& [id, object] : file.readMemory().objects) EXPECT_LT(object.lastSeen_s, 10.0);
}

TEST_F(Privacy, WhatCannotBeKeptIsNotPromised) {
  const RoomRecording room(2);
  expectError(run(room.path(), {"--no-network", "--private"}), 2, "--private needs masks or a network");
  expectError(run(room.path(), {"--filter", "off", "--pictures"}), 2, "--keep-people");
  const fs::path map = room.write("map.wardmap", "");
  expectError(run(room.path(), {"--masks", room.masks(), "--map", map, "--private"}), 2, "--private begins a new map");
}

TEST_F(Privacy, PicturesShowPeopleOnlyWhereAsked) {
  const RoomRecording room(kImages);
  const fs::path few = room.write("few.yaml", "features:\n  key_points: 300\n");
  /// Share of pixels of one grey where the person is: key points and tags are painted over some.
  const auto flatPart = [&] {
    const cv::Mat picture = cv::imread((out / "pictures" / "1000.000000.jpg").string(), cv::IMREAD_GRAYSCALE);
    std::vector<std::uint8_t> pixels;
    for (int y = 20; y < 200; ++y) pixels.insert(pixels.end(), picture.ptr(y) + 20, picture.ptr(y) + 70);
    std::sort(pixels.begin(), pixels.end());
    const int median = pixels[pixels.size() / 2];
    const auto isFlat = [median](std::uint8_t grey) { return std::abs(grey - median) <= 6; };
    return static_cast<double>(std::count_if(pixels.begin(), pixels.end(), isFlat)) /
           static_cast<double>(pixels.size());
  };
  ASSERT_EQ(run(room.path(), {"--masks", room.masks(), "--config", few, "--pictures", "--keep-people"}).exitCode, 0);
  const double kept = flatPart();
  ASSERT_EQ(run(room.path(), {"--masks", room.masks(), "--config", few, "--pictures"}).exitCode, 0);
  EXPECT_GT(flatPart(), 2.0 * kept);
}

}  // namespace
}  // namespace wardslam::test
