#include "rawlog_source.h"

#include <gmock/gmock.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/io/CFileOutputStream.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include <opencv2/imgcodecs.hpp>

#include "sources/scan_maker.h"
#include "sources/stereo_pair_maker.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

using mrpt::obs::CObservation3DRangeScan;
using test::makeScan;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::ThrowsMessage;

using Objects = std::vector<mrpt::serialization::CSerializable::Ptr>;

class RawlogFile : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { mrpt::img::CImage::DISABLE_JPEG_COMPRESSION(true); }

  template <class Stream = mrpt::io::CFileGZOutputStream>
  void write(const Objects& objects) const {
    Stream stream;
    ASSERT_TRUE(stream.open(file.string()));
    auto archive = mrpt::serialization::archiveFrom(stream);
    for (const auto& object : objects) archive << *object;
  }

  /// Reads to the end: the second of each stamp, 1000 taken off.
  std::vector<int> readNumbers() {
    SourceOptions options;
    options.warn = [this](const std::string& sentence) { warnings.push_back(sentence); };
    RawlogSource source(file, options);
    std::vector<int> numbers;
    while (const auto scan = source.next()) {
      numbers.push_back(static_cast<int>(core::fromMrptTime(scan->timestamp) + 0.5) - 1000);
    }
    damage = source.damage();
    return numbers;
  }

  void expectError(const std::string& what) const {
    EXPECT_THAT([&] { RawlogSource(file, {}); },
                ThrowsMessage<core::InputError>(AllOf(HasSubstr(file.string()), HasSubstr(what))));
  }

  test::TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "ward.rawlog";
  std::vector<std::string> warnings;
  core::EventCounts damage;
};

TEST_F(RawlogFile, DeliversItsScansUnchanged) {
  const auto written = makeScan(3);
  write({written});
  RawlogSource source(file, {});
  EXPECT_EQ(source.size(), std::nullopt);
  const auto scan = source.next();
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->timestamp, written->timestamp);
  EXPECT_EQ(cv::norm(scan->intensityImage.asCvMatRef(), written->intensityImage.asCvMatRef(), cv::NORM_INF), 0.0);
  EXPECT_EQ(scan->rangeImage, written->rangeImage);
  EXPECT_EQ(scan->cameraParams, written->cameraParams);
  EXPECT_FALSE(source.next());
}

TEST_F(RawlogFile, MayBeUncompressed) {
  write<mrpt::io::CFileOutputStream>({makeScan(0), makeScan(1)});
  EXPECT_THAT(readNumbers(), ElementsAre(0, 1));
}

TEST_F(RawlogFile, MayConsistOfSensoryFrames) {
  const auto sensoryFrame = std::make_shared<mrpt::obs::CSensoryFrame>();
  sensoryFrame->insert(makeScan(1));
  sensoryFrame->insert(std::make_shared<mrpt::obs::CObservationOdometry>());
  sensoryFrame->insert(makeScan(2));
  const auto second = std::make_shared<mrpt::obs::CSensoryFrame>();
  second->insert(makeScan(3));
  const auto actions = std::make_shared<mrpt::obs::CActionCollection>();
  write({actions, sensoryFrame, actions, second});
  EXPECT_THAT(readNumbers(), ElementsAre(1, 2, 3));
  EXPECT_THAT(damage, IsEmpty());
}

TEST_F(RawlogFile, OtherObservationsAndSensorsArePassedOver) {
  const auto depthOnly = makeScan(1);
  depthOnly->hasIntensityImage = false;
  const auto otherCamera = makeScan(3);
  otherCamera->sensorLabel = "REAR_CAMERA";
  write({std::make_shared<mrpt::obs::CObservationOdometry>(), depthOnly, makeScan(2), otherCamera, makeScan(4)});
  EXPECT_THAT(readNumbers(), ElementsAre(2, 4));
  EXPECT_THAT(damage, IsEmpty());
  EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(RawlogFile, CutOffInTheMiddleGivesEverythingBefore) {
  write({makeScan(0), makeScan(1), makeScan(2)});
  const auto size = std::filesystem::file_size(file);
  std::filesystem::resize_file(file, size - size / 6);  // within the last of three scans
  EXPECT_THAT(readNumbers(), ElementsAre(0, 1));
  EXPECT_THAT(damage, ElementsAre(Pair("sources.rawlog_truncated", 1)));
  EXPECT_THAT(warnings, ElementsAre(AllOf(HasSubstr(file.string()), HasSubstr("cut off"), HasSubstr("after 2"))));
}

TEST_F(RawlogFile, CutOffUncompressedGivesEverythingBefore) {
  write<mrpt::io::CFileOutputStream>({makeScan(0), makeScan(1), makeScan(2)});
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 3);
  EXPECT_THAT(readNumbers(), ElementsAre(0, 1));
  EXPECT_THAT(damage, ElementsAre(Pair("sources.rawlog_truncated", 1)));
}

TEST_F(RawlogFile, CutOffBeforeTheFirstScanIsAnError) {
  write({std::make_shared<mrpt::obs::CObservationOdometry>(), makeScan(0)});
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  expectError("holds no CObservation3DRangeScan");
}

TEST_F(RawlogFile, AnObjectOfAnUnknownClassEndsIt) {
  write<mrpt::io::CFileOutputStream>({makeScan(0), std::make_shared<mrpt::obs::CObservationOdometry>(), makeScan(1)});
  std::string bytes = test::readText(file);
  const std::string name = "CObservationOdometry";
  bytes.replace(bytes.find(name), name.size(), "CObservationOdometrX");
  folder.write("ward.rawlog", bytes);
  EXPECT_THAT(readNumbers(), ElementsAre(0));
  EXPECT_THAT(damage, ElementsAre(Pair("sources.rawlog_unknown_class", 1)));
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("CObservationOdometrX")));
}

TEST_F(RawlogFile, ThatIsEmptyIsAnError) {
  folder.write("ward.rawlog", "");
  expectError("is empty or not a rawlog");
}

TEST_F(RawlogFile, ThatIsSomethingElseIsAnError) {
  folder.write("ward.rawlog", "timestamp tx ty tz qx qy qz qw\n");
  expectError("is empty or not a rawlog");
}

TEST_F(RawlogFile, ThatIsMissingIsAnError) { expectError("cannot be opened"); }

TEST_F(RawlogFile, WithoutScansIsAnErrorThatTellsWhatItHolds) {
  write({std::make_shared<mrpt::obs::CObservationOdometry>()});
  expectError("only: mrpt::obs::CObservationOdometry");
}

TEST_F(RawlogFile, OnlyOfUnusableScansIsAnError) {
  const auto scan = makeScan(0);
  scan->rangeUnits = 0.0F;
  write({scan});
  expectError("none of its RGB-D or stereo observations can be used; observation 1: has no valid range unit");
}

TEST_F(RawlogFile, AnUnusableScanIsLeftOut) {
  const auto unusable = makeScan(1);
  unusable->cameraParams.intrinsicParams.setZero();
  write({makeScan(0), unusable, makeScan(2)});
  EXPECT_THAT(readNumbers(), ElementsAre(0, 2));
  EXPECT_THAT(damage, ElementsAre(Pair("sources.observation_unusable", 1)));
  EXPECT_THAT(warnings, ElementsAre(AllOf(HasSubstr("observation 2"), HasSubstr("no calibration"))));
}

TEST_F(RawlogFile, AScanFromBeforeTheOneDeliveredLastIsLeftOut) {
  write({makeScan(3), makeScan(1), makeScan(2), makeScan(3), makeScan(4)});
  EXPECT_THAT(readNumbers(), ElementsAre(3, 3, 4));
  EXPECT_THAT(damage, ElementsAre(Pair("sources.stamp_goes_back", 2)));
  EXPECT_THAT(warnings, ElementsAre(AllOf(HasSubstr("observation 2"), HasSubstr("2.000000 s before"))));
}

TEST_F(RawlogFile, AGivenCameraReplacesTheCalibration) {
  write({makeScan(0, 16, 16)});
  SourceOptions options;
  options.camera = folder.write("camera.yaml", "width: 16\nheight: 16\nfx: 9\nfy: 9\ncx: 3.5\ncy: 2.5\n");
  const auto scan = RawlogSource(file, options).next();
  EXPECT_EQ(scan->cameraParamsIntensity.fx(), 9.0);
  EXPECT_EQ(scan->cameraParams.fx(), 9.0);
}

TEST_F(RawlogFile, TheUnitOfACameraFileDoesNotCountAndThatIsSaid) {
  const auto scan = makeScan(0, 16, 16);
  scan->rangeUnits = 0.001F;
  write({scan});
  std::vector<std::string> notes;
  SourceOptions options;
  options.note = [&](const std::string& sentence) { notes.push_back(sentence); };
  const std::string camera = "width: 16\nheight: 16\nfx: 9\nfy: 9\ncx: 7.5\ncy: 7.5\ndepth_factor: ";
  options.camera = folder.write("camera.yaml", camera + "1000\n");
  const RawlogSource silent(file, options);
  EXPECT_TRUE(notes.empty());
  options.camera = folder.write("camera.yaml", camera + "5000\n");
  const RawlogSource telling(file, options);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes[0], AllOf(HasSubstr("1000 units a metre, which counts"), HasSubstr("not 5000")));
}

TEST_F(RawlogFile, AGivenCameraIsThatOfTheColourImage) {
  const auto twoCameras = makeScan(0, 16, 16);
  twoCameras->relativePoseIntensityWRTDepth.y(0.02);
  write({twoCameras});
  SourceOptions options;
  options.camera = folder.write("camera.yaml", "width: 16\nheight: 16\nfx: 9\nfy: 9\ncx: 3.5\ncy: 2.5\n");
  const auto scan = RawlogSource(file, options).next();
  EXPECT_EQ(scan->cameraParamsIntensity.fx(), 9.0);
  EXPECT_EQ(scan->cameraParams.fx(), 8.0);
}

TEST_F(RawlogFile, PairsOfAStereoCameraBecomeScans) {
  const test::StereoScene scene;
  write({scene.record(0), scene.record(1)});
  RawlogSource source(file, {});
  EXPECT_NEAR(source.sensorTraits().depthNoise.sigma_m(2.0), 4.0 / 25 * StereoOptions().disparity_sigma_px, 1e-9);
  const auto scan = source.next();
  ASSERT_TRUE(scan);
  EXPECT_NEAR(scan->rangeImage(120, 160) * static_cast<double>(scan->rangeUnits), 2.0, 0.1);
  EXPECT_TRUE(source.next());
  EXPECT_FALSE(source.next());
}

TEST_F(RawlogFile, AnUnusablePairIsLeftOut) {
  const auto blind = test::StereoScene().record(1);
  blind->hasImageRight = false;
  write({test::StereoScene().record(0), blind, test::StereoScene().record(2)});
  EXPECT_THAT(readNumbers(), ElementsAre(0, 2));
  EXPECT_THAT(damage, ElementsAre(Pair("sources.observation_unusable", 1)));
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("observation 2: the stereo pair has no right image")));
}

TEST_F(RawlogFile, OnlyOfUnusablePairsIsAnErrorThatTellsWhy) {
  const auto blind = test::StereoScene().record();
  blind->hasImageRight = false;
  write({blind});
  expectError("observation 1: the stereo pair has no right image");
}

TEST_F(RawlogFile, OfAStereoCameraTakesNoCameraFile) {
  write({test::StereoScene().record()});
  SourceOptions options;
  options.camera = folder.write("camera.yaml", "width: 16\nheight: 16\nfx: 9\nfy: 9\ncx: 3.5\ncy: 2.5\n");
  EXPECT_THAT([&] { RawlogSource(file, options); }, ThrowsMessage<core::InputError>(HasSubstr("stereo camera")));
}

TEST_F(RawlogFile, TheNoiseAndTheReadoutOfACameraFileAreThoseOfTheCamera) {
  write({makeScan(0, 16, 16)});
  SourceOptions options;
  options.camera = folder.write(
      "camera.yaml",
      "width: 16\nheight: 16\nfx: 9\nfy: 9\ncx: 3.5\ncy: 2.5\ndepth_noise: {growth: 0.01}\nreadout: 0.02\n");
  EXPECT_EQ(RawlogSource(file, options).sensorTraits().depthNoise.growth_per_m, 0.01);
  EXPECT_EQ(RawlogSource(file, options).sensorTraits().readout_s, 0.02);
  EXPECT_EQ(RawlogSource(file, {}).sensorTraits().depthNoise, core::DepthNoise());
}

TEST_F(RawlogFile, CountsItsSensorsAndTakesTheOneAskedFor) {
  const auto rear = [](int number) {
    auto scan = makeScan(number);
    scan->sensorLabel = "REAR";
    return scan;
  };
  write({makeScan(0), rear(1), makeScan(2), rear(3), rear(4)});
  EXPECT_THAT(readNumbers(), ElementsAre(0, 2));
  SourceOptions options;
  options.sensor = "REAR";
  RawlogSource source(file, options);
  std::size_t scans = 0;
  while (source.next()) ++scans;
  EXPECT_EQ(scans, 3U);
  EXPECT_THAT(source.sensors().observations, ElementsAre(Pair("CAMERA", 2), Pair("REAR", 3)));
  EXPECT_EQ(source.sensors().taken, "REAR");
  EXPECT_THAT(source.sensors().sentence().value_or(""),
              AllOf(HasSubstr("CAMERA (2), REAR (3)"), HasSubstr("those of REAR"), HasSubstr("--sensor")));
  options.sensor = "SIDE";
  EXPECT_THAT([&] { RawlogSource(file, options); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("'SIDE'"), HasSubstr("CAMERA, REAR"))));
}

TEST_F(RawlogFile, OfOneSensorNeedsNoSentence) {
  write({makeScan(0)});
  EXPECT_EQ(RawlogSource(file, {}).sensors().sentence(), std::nullopt);
}

TEST_F(RawlogFile, AGivenUnitReplacesThatOfTheScans) {
  write({makeScan(0)});
  SourceOptions options;
  options.depth_units_per_m = 5000.0;
  EXPECT_FLOAT_EQ(RawlogSource(file, options).next()->rangeUnits, 0.0002F);
}

TEST_F(RawlogFile, OfANewerMrptIsNamedAsSuch) {
  write<mrpt::io::CFileOutputStream>({std::make_shared<mrpt::obs::CObservationOdometry>(), makeScan(0)});
  std::string bytes = test::readText(file);
  const std::string name = "CObservation3DRangeScan";
  const std::size_t at = bytes.find(name);
  ASSERT_NE(at, std::string::npos);
  bytes[at + name.size()] = 120;  // the version
  folder.write("ward.rawlog", bytes);
  expectError("written by a newer MRPT (CObservation3DRangeScan, version 120)");
}

TEST_F(RawlogFile, StopsWhereTheFirstScansAllFailAlike) {
  Objects scans;
  for (int i = 0; i < 15; ++i) {
    const auto scan = makeScan(i);
    scan->cameraParamsIntensity.cx(1000.0);
    scan->cameraParams.cx(1000.0);
    scans.push_back(scan);
  }
  write(scans);
  expectError(
      "principal point lies outside its image of 8x6 pixels; give the right --camera; so it is with all of the first "
      "10");
}

/// Scans whose images lie in files beside the rawlog, as rawlog-grabber leaves them.
class RawlogWithExternalImages : public RawlogFile {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(images);
    write({makeExternalScan(0), makeExternalScan(1), makeExternalScan(2)});
  }
  [[nodiscard]] CObservation3DRangeScan::Ptr makeExternalScan(int number) const {
    auto scan = makeScan(number);
    const std::string name = std::to_string(number);
    cv::imwrite((images / (name + ".png")).string(), scan->intensityImage.asCvMatRef());
    scan->intensityImage.setExternalStorage(name + ".png");
    scan->rangeImage_convertToExternalStorage(name + ".bin", images.string() + "/");
    return scan;
  }
  std::filesystem::path images = folder.path() / "ward_Images";
};

TEST_F(RawlogWithExternalImages, LoadsThem) {
  RawlogSource source(file, {});
  static_cast<void>(source.next());
  const auto scan = source.next();
  const auto expected = makeScan(1);
  ASSERT_TRUE(scan);
  EXPECT_EQ(cv::norm(scan->intensityImage.asCvMatRef(), expected->intensityImage.asCvMatRef(), cv::NORM_INF), 0.0);
  EXPECT_EQ(scan->rangeImage, expected->rangeImage);
}

TEST_F(RawlogWithExternalImages, NamesTheFolderThatIsMissing) {
  std::filesystem::rename(images, folder.path() / "elsewhere");
  expectError("folder ward_Images beside it, which is not there");
}

TEST_F(RawlogWithExternalImages, AMissingImageIsLeftOut) {
  std::filesystem::remove(images / "1.png");
  EXPECT_THAT(readNumbers(), ElementsAre(0, 2));
  EXPECT_THAT(damage, ElementsAre(Pair("sources.image_missing", 1)));
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("1.png")));
}

TEST_F(RawlogWithExternalImages, ATruncatedImageIsLeftOut) {
  std::filesystem::resize_file(images / "1.png", std::filesystem::file_size(images / "1.png") / 2);
  EXPECT_THAT(readNumbers(), ElementsAre(0, 2));
  EXPECT_THAT(damage, ElementsAre(Pair("sources.image_truncated", 1)));
}

TEST_F(RawlogWithExternalImages, LoadsThoseOfStereoPairsToo) {
  const test::StereoScene scene;
  const auto pair = scene.record();
  for (auto* image : {&pair->imageLeft, &pair->imageRight}) {
    const std::string name = image == &pair->imageLeft ? "left.png" : "right.png";
    cv::imwrite((images / name).string(), image->asCvMatRef());
    image->setExternalStorage(name);
  }
  write({pair});
  const auto scan = RawlogSource(file, {}).next();
  ASSERT_TRUE(scan);
  EXPECT_NEAR(scan->rangeImage(120, 160) * static_cast<double>(scan->rangeUnits), 2.0, 0.1);
}

TEST_F(RawlogWithExternalImages, AMissingRangeImageIsLeftOut) {
  std::filesystem::remove(images / "1.bin");
  EXPECT_THAT(readNumbers(), ElementsAre(0, 2));
  EXPECT_THAT(damage, ElementsAre(Pair("sources.image_missing", 1)));
}

TEST_F(RawlogWithExternalImages, ATruncatedRangeImageIsLeftOut) {
  std::filesystem::resize_file(images / "1.bin", std::filesystem::file_size(images / "1.bin") / 2);
  EXPECT_THAT(readNumbers(), ElementsAre(0, 2));
  EXPECT_THAT(damage, ElementsAre(Pair("sources.image_truncated", 1)));
}

}  // namespace
}  // namespace wardslam::sources
