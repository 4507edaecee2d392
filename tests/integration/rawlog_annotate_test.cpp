#include <gmock/gmock.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CSerializable.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "cli_test_support.h"
#include "recording/rawlog_writer.h"
#include "room_recording.h"
#include "wardslam/core/annotation.h"
#include "wardslam/mrpt_plugin/observation_semantic_rgbd.h"
#include "wardslam/mrpt_plugin/register_all.h"
#include "wardslam/sources/external_images.h"
#include "wardslam/sources/observation_source.h"
#include "wardslam/sources/rawlog_reader.h"

namespace wardslam {
namespace {

namespace fs = std::filesystem;
using mrpt::obs::CObservation3DRangeScan;
using mrpt_plugin::CObservationSemanticRGBD;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Objects = std::vector<mrpt::serialization::CSerializable::Ptr>;

constexpr int kImages = 6;

const test::RoomRecording& room() {
  static const test::RoomRecording kRoom(kImages);
  return kRoom;
}

class RawlogAnnotate : public ::testing::Test {
 protected:
  RawlogAnnotate() { mrpt_plugin::registerAll(); }

  /// The room as scans, each prepared by `prepare`, with an odometry reading before each; then `last` as it is.
  void record(int rounds = 1, const std::function<void(CObservation3DRangeScan&, int)>& prepare = {},
              const std::vector<std::uint8_t>& last = {}) const {
    recording::RawlogWriter writer(input);
    for (int round = 0; round < rounds; ++round) {
      const auto source = sources::openSource(room().path(), {});
      for (int i = 0; const auto scan = source->next(); ++i) {
        writer.write(mrpt::obs::CObservationOdometry());
        if (prepare) prepare(*scan, i);
        writer.write(*scan);
      }
    }
    if (!last.empty()) writer.write(last);
    writer.commit();
  }

  /// An odometry reading of a version that nobody knows yet.
  static std::vector<std::uint8_t> newerOdometry() {
    const mrpt::obs::CObservationOdometry odometry;
    std::vector<std::uint8_t> bytes;
    mrpt::serialization::ObjectToOctetVector(&odometry, bytes);
    bytes.at(1 + (bytes.at(0) & 0x7FU)) = 99;  // behind the name of the class, which its length precedes
    return bytes;
  }

  /// A run that ends once it has made a checkpoint.
  void annotateAndKill() const {
    test::RunningProgram killed("rawlog-annotate", command());
    const fs::path resume = output.string() + ".resume";
    for (int i = 0; i < 600 && !fs::exists(resume); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    killed.send(SIGKILL);
    EXPECT_EQ(killed.wait().exitCode, 128 + SIGKILL);
    EXPECT_FALSE(fs::exists(output));
    ASSERT_TRUE(fs::exists(resume));
  }

  [[nodiscard]] std::vector<std::string> command(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {input.string(), "-o", output.string(), "--masks", room().masks().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  [[nodiscard]] test::CommandResult annotate(const std::vector<std::string>& more = {}) const {
    return test::runProgram("rawlog-annotate", command(more));
  }

  static Objects read(const fs::path& file) {
    sources::RawlogReader reader(file);
    Objects objects;
    while (auto object = reader.read()) objects.push_back(object);
    return objects;
  }

  template <class Class>
  static std::vector<std::shared_ptr<Class>> only(const Objects& objects) {
    std::vector<std::shared_ptr<Class>> some;
    for (const auto& object : objects) {
      if (auto one = std::dynamic_pointer_cast<Class>(object)) some.push_back(one);
    }
    return some;
  }

  /// The left quarter of every image is a person.
  static void expectPersonMarked(const CObservation3DRangeScan& scan) {
    const cv::Mat bits = core::annotationOf(scan);
    ASSERT_EQ(bits.size(), cv::Size(320, 240));
    const int person = core::bitOf(core::PixelLabel::Dynamic) | core::bitOf(core::PixelLabel::Person);
    EXPECT_EQ(bits.at<std::uint8_t>(120, 20), person);
    EXPECT_EQ(bits.at<std::uint8_t>(120, 200), 0);
    ASSERT_TRUE(scan.hasConfidenceImage);
    EXPECT_EQ(scan.confidenceImage.asCvMatRef().at<std::uint8_t>(120, 20), 0);
    EXPECT_EQ(scan.confidenceImage.asCvMatRef().at<std::uint8_t>(120, 200), 255);
  }

  test::TemporaryFolder folder;
  fs::path input = folder.path() / "in.rawlog";
  fs::path output = folder.path() / "out.rawlog";
  fs::path sidecar = folder.path() / "out_sem.rawlog";
};

TEST_F(RawlogAnnotate, WritesAnAnnotatedCopyAndASidecar) {
  record();
  const std::string before = test::readText(input);
  const auto result = annotate({"--keep-people"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("12 objects, of which 6 scans annotated"), HasSubstr("out_sem.rawlog")));
  EXPECT_EQ(test::readText(input), before);

  const Objects objects = read(output);
  EXPECT_EQ(objects.size(), 2U * kImages);
  EXPECT_EQ(only<mrpt::obs::CObservationOdometry>(objects).size(), std::size_t{kImages});
  const auto scans = only<CObservation3DRangeScan>(objects);
  const auto originals = only<CObservation3DRangeScan>(read(input));
  const auto semantic = only<CObservationSemanticRGBD>(read(sidecar));
  ASSERT_EQ(scans.size(), std::size_t{kImages});
  ASSERT_EQ(semantic.size(), std::size_t{kImages});
  for (std::size_t i = 0; i < kImages; ++i) {
    expectPersonMarked(*scans[i]);
    EXPECT_EQ(scans[i]->rangeImage, originals[i]->rangeImage);
    EXPECT_EQ(cv::norm(scans[i]->intensityImage.asCvMatRef(), originals[i]->intensityImage.asCvMatRef(), cv::NORM_INF),
              0.0);
    EXPECT_EQ(semantic[i]->timestamp, scans[i]->timestamp);
    EXPECT_EQ(semantic[i]->sensorLabel, "RGBD_SEM");
    EXPECT_EQ(semantic[i]->segmentation.classIds.at<core::ClassId>(120, 20), 1);
    EXPECT_GT(semantic[i]->features.size(), 100U);
  }
}

TEST_F(RawlogAnnotate, EmbedsAfterEachScanAndReplacesWhatWasEmbedded) {
  record();
  ASSERT_EQ(annotate({"--embed"}).exitCode, 0);
  EXPECT_FALSE(fs::exists(sidecar));
  const Objects objects = read(output);
  ASSERT_EQ(objects.size(), 3U * kImages);
  EXPECT_TRUE(std::dynamic_pointer_cast<CObservation3DRangeScan>(objects[1]));
  EXPECT_TRUE(std::dynamic_pointer_cast<CObservationSemanticRGBD>(objects[2]));

  const fs::path again = folder.path() / "again.rawlog";
  const auto result = test::runProgram(
      "rawlog-annotate", {output.string(), "-o", again.string(), "--embed", "--masks", room().masks().string()});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(read(again).size(), 3U * kImages);
}

TEST_F(RawlogAnnotate, ReachesIntoSensoryFrames) {
  recording::RawlogWriter writer(input);
  const auto source = sources::openSource(room().path(), {});
  mrpt::obs::CSensoryFrame frame;
  frame.insert(std::make_shared<mrpt::obs::CObservationOdometry>());
  frame.insert(source->next());
  writer.write(frame);
  writer.commit();
  ASSERT_EQ(annotate({"--embed"}).exitCode, 0);
  const auto observations = sources::observationsIn(read(output).at(0));
  ASSERT_EQ(observations.size(), 3U);
  expectPersonMarked(dynamic_cast<const CObservation3DRangeScan&>(*observations[1]));
  EXPECT_EQ(observations[2]->sensorLabel, "RGBD_SEM");
}

TEST_F(RawlogAnnotate, LeavesExternalImagesWhereTheyAre) {
  const fs::path images = folder.path() / "in_Images";
  fs::create_directory(images);
  record(1, [&](CObservation3DRangeScan& scan, int i) {
    const std::string name = "3DCAM_" + std::to_string(i) + "_INT.png";
    ASSERT_TRUE(scan.intensityImage.saveToFile((images / name).string()));
    scan.intensityImage.setExternalStorage(name);
  });
  ASSERT_EQ(annotate({"--keep-people"}).exitCode, 0);
  EXPECT_LT(fs::file_size(output), fs::file_size(input) + 100000);
  sources::RawlogReader reader(output);
  static_cast<void>(reader.read());
  const auto scan = std::dynamic_pointer_cast<CObservation3DRangeScan>(reader.read());
  ASSERT_TRUE(scan);
  EXPECT_TRUE(scan->intensityImage.isExternallyStored());
  EXPECT_NO_THROW(sources::loadImages(*scan));
  expectPersonMarked(*scan);
}

/// The left quarter of every image is a person; beyond the margin around, nothing changes.
TEST_F(RawlogAnnotate, BlanksPeopleUnlessAsked) {
  const fs::path images = folder.path() / "in_Images";
  fs::create_directory(images);
  record(1, [&](CObservation3DRangeScan& scan, int i) {
    if (i > 0) return;
    ASSERT_TRUE(scan.intensityImage.saveToFile((images / "outside.png").string()));
    scan.intensityImage.setExternalStorage("outside.png");
  });
  ASSERT_EQ(annotate().exitCode, 0);
  const auto scans = only<CObservation3DRangeScan>(read(output));
  const auto originals = only<CObservation3DRangeScan>(read(input));
  const auto semantic = only<CObservationSemanticRGBD>(read(sidecar));
  ASSERT_EQ(scans.size(), std::size_t{kImages});
  for (std::size_t i = 0; i < kImages; ++i) {
    ASSERT_FALSE(scans[i]->intensityImage.isExternallyStored());
    const cv::Mat color = scans[i]->intensityImage.asCvMatRef();
    const cv::Mat grey(240, 80, CV_8UC3, cv::Scalar::all(128));
    EXPECT_EQ(cv::norm(color(cv::Rect(0, 0, 80, 240)), grey, cv::NORM_INF), 0.0);
    const cv::Rect rest(120, 0, 200, 240);
    if (i > 0) {
      EXPECT_EQ(cv::norm(color(rest), originals[i]->intensityImage.asCvMatRef()(rest), cv::NORM_INF), 0.0);
    }
    EXPECT_EQ(scans[i]->rangeImage.block(0, 0, 240, 80).maxCoeff(), 0);
    EXPECT_EQ(scans[i]->rangeImage.block(0, 120, 240, 200), originals[i]->rangeImage.block(0, 120, 240, 200));
    for (const auto& keypoint : semantic[i]->features.keypoints) EXPECT_GE(keypoint.raw_px.x, 79.5F);
    EXPECT_EQ(semantic[i]->states.size(), semantic[i]->features.size());
    EXPECT_GT(semantic[i]->features.size(), 50U);
    expectPersonMarked(*scans[i]);
  }
}

TEST_F(RawlogAnnotate, BlanksNobodyWhoCannotBeFound) {
  record();
  const auto withoutMasks = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {input.string(), "-o", output.string(), "--no-network"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::runProgram("rawlog-annotate", arguments);
  };
  const auto refused = withoutMasks({});
  EXPECT_EQ(refused.exitCode, 2);
  EXPECT_THAT(refused.err, HasSubstr("--keep-people"));
  EXPECT_FALSE(fs::exists(output));
  EXPECT_EQ(withoutMasks({"--keep-people"}).exitCode, 0);
}

TEST_F(RawlogAnnotate, GoesOnWhereItWasKilled) {
  record(25);
  annotateAndKill();
  const auto result = annotate();
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("going on behind the first"));
  const auto scans = only<CObservation3DRangeScan>(read(output));
  const auto originals = only<CObservation3DRangeScan>(read(input));
  ASSERT_EQ(scans.size(), originals.size());
  for (std::size_t i = 0; i < scans.size(); ++i) {
    ASSERT_EQ(scans[i]->timestamp, originals[i]->timestamp);
    expectPersonMarked(*scans[i]);
  }
  EXPECT_EQ(read(sidecar).size(), scans.size());
  EXPECT_FALSE(fs::exists(output.string() + ".resume"));
  EXPECT_FALSE(fs::exists(output.string() + ".partial"));
}

TEST_F(RawlogAnnotate, LeavesNothingWhereTheInputIsAtFaultHoweverFarItWas) {
  record(25, {}, newerOdometry());
  annotateAndKill();
  const auto result = annotate();
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("written by a newer MRPT (CObservationOdometry, version 99)"));
  for (const auto& entry : fs::directory_iterator(folder.path())) EXPECT_EQ(entry.path().filename(), "in.rawlog");
}

TEST_F(RawlogAnnotate, NeverWritesOverItsInput) {
  record();
  const std::string before = test::readText(input);
  const auto result =
      test::runProgram("rawlog-annotate", {input.string(), "-o", input.string(), "--masks", room().masks().string()});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("is the input"));
  EXPECT_EQ(test::readText(input), before);
}

TEST_F(RawlogAnnotate, KeepsTheSoundPartOfARawlogThatIsCutOff) {
  record();
  fs::resize_file(input, fs::file_size(input) * 3 / 4);
  const auto result = annotate();
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("is cut off or damaged"));
  EXPECT_GT(only<CObservation3DRangeScan>(read(output)).size(), 2U);
}

TEST_F(RawlogAnnotate, TellsOfWhatIsNoRawlog) {
  folder.write("in.rawlog", "no rawlog");
  const auto result = annotate();
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("in.rawlog: "));
  EXPECT_FALSE(fs::exists(output));
  EXPECT_FALSE(fs::exists(output.string() + ".partial"));
}

}  // namespace
}  // namespace wardslam
