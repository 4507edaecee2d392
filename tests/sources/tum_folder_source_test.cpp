#include "tum_folder_source.h"

#include <gmock/gmock.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <limits>

#include "sources/tum_folder_writer.h"
#include "support/complaint.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::sources {
namespace {

using test::TumFolder;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::ThrowsMessage;

cv::Mat colorOf(const mrpt::obs::CObservation3DRangeScan& scan) { return scan.intensityImage.asCvMatRef(); }

cv::Mat depthOf(mrpt::obs::CObservation3DRangeScan& scan) {
  return {static_cast<int>(scan.rangeImage.rows()), static_cast<int>(scan.rangeImage.cols()), CV_16UC1,
          scan.rangeImage.data()};
}

double difference(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF); }

/// Reads to the end; which frames came, what was warned of.
struct Reading {
  explicit Reading(const std::filesystem::path& folder, SourceOptions options = {}) {
    options.note = [this](const std::string& sentence) { notes.push_back(sentence); };
    options.warn = [this](const std::string& sentence) { warnings.push_back(sentence); };
    TumFolderSource source(folder, options);
    while (const auto scan = source.next()) stamps_s.push_back(core::fromMrptTime(scan->timestamp));
    damage = source.damage();
  }
  std::vector<double> stamps_s;
  std::vector<std::string> warnings;
  std::vector<std::string> notes;
  core::EventCounts damage;
};

TEST(TumFolderSource, DeliversEveryPairAsAnMrptObservation) {
  const TumFolder folder(3);
  TumFolderSource source(folder.path(), {});
  EXPECT_EQ(source.size(), 3U);
  for (int i = 0; i < 3; ++i) {
    const auto scan = source.next();
    ASSERT_TRUE(scan);
    EXPECT_NEAR(core::fromMrptTime(scan->timestamp), TumFolder::colorStamp_s(i), 1e-6);
    EXPECT_EQ(scan->sensorLabel, "RGBD");
    EXPECT_EQ(difference(colorOf(*scan), TumFolder::colorImage(i)), 0.0);
    EXPECT_EQ(difference(depthOf(*scan), TumFolder::depthImage(i)), 0.0);
    EXPECT_FLOAT_EQ(scan->rangeUnits, 0.0002F);
    EXPECT_TRUE(scan->range_is_depth);
    EXPECT_TRUE(scan->doDepthAndIntensityCamerasCoincide());
    EXPECT_EQ(scan->cameraParams, scan->cameraParamsIntensity);
    EXPECT_EQ(scan->cameraParams.fy(), 31.0);
    EXPECT_EQ(scan->cameraParams.k1(), 0.1);
  }
  EXPECT_FALSE(source.next());
  EXPECT_FALSE(source.next());
  EXPECT_THAT(source.damage(), IsEmpty());
}

TEST(TumFolderSource, ReadsJpeg) {
  const TumFolder folder(1, "jpg");
  TumFolderSource source(folder.path(), {});
  const auto scan = source.next();
  ASSERT_TRUE(scan);
  EXPECT_LT(cv::norm(colorOf(*scan), TumFolder::colorImage(0), cv::NORM_L1) / (32 * 24 * 3), 8.0);
}

TEST(TumFolderSource, MakesColourOfMonochromeImages) {
  const TumFolder folder(1);
  cv::Mat gray;
  cv::extractChannel(TumFolder::colorImage(0), gray, 1);
  folder.writeImage(TumFolder::colorFile(0), gray);
  TumFolderSource source(folder.path(), {});
  const auto scan = source.next();
  ASSERT_TRUE(scan);
  EXPECT_EQ(colorOf(*scan).at<cv::Vec3b>(3, 20), cv::Vec3b(140, 140, 140));  // 7 * column 20
}

TEST(TumFolderSource, FollowsTheDepthUnitOfTheCameraFile) {
  const TumFolder folder(1);
  folder.write("camera.yaml",
               "width: 32\nheight: 24\nfx: 30\nfy: 30\ncx: 15.5\ncy: 11.5\ndepth_factor: 1000\nfps: 30\n");
  TumFolderSource source(folder.path(), {});
  EXPECT_FLOAT_EQ(source.next()->rangeUnits, 0.001F);
}

TEST(TumFolderSource, AGivenCameraFileReplacesThatOfTheFolder) {
  const TumFolder folder(1);
  SourceOptions options;
  options.camera =
      folder.write("other.yaml", "width: 32\nheight: 24\nfx: 77\nfy: 30\ncx: 15.5\ncy: 11.5\ndepth_factor: 1000\n");
  TumFolderSource source(folder.path(), options);
  EXPECT_EQ(source.next()->cameraParams.fx(), 77.0);
}

/// The images are smaller than TUM's: the warning tells that the camera was found.
std::string complaintAboutImageSize(const std::filesystem::path& folder) {
  const Reading reading(folder);
  EXPECT_THAT(reading.damage, ElementsAre(Pair("sources.image_size", 1)));
  return reading.warnings.empty() ? "" : reading.warnings.front();
}

TEST(TumFolderSource, KnowsTumsCamerasByTheFolderName) {
  const TumFolder folder(1);
  std::filesystem::remove(folder.path() / "camera.yaml");
  for (const std::string name :
       {"rgbd_dataset_freiburg1_xyz", "rgbd_dataset_freiburg3_walking_xyz", "rgbd_dataset_freiburg2_desk-2"}) {
    const auto named = folder.path() / name;
    std::filesystem::create_directory(named);
    for (const std::string part : {"rgb", "depth", "rgb.txt", "depth.txt"}) {
      std::filesystem::create_symlink(folder.path() / part, named / part);
    }
    EXPECT_THAT(complaintAboutImageSize(named / "."), HasSubstr("camera 640x480"));
  }
}

TEST(TumFolderSource, TakesNoOtherFolderForOneOfTums) {
  const TumFolder folder(1);
  std::filesystem::remove(folder.path() / "camera.yaml");
  for (const std::string name : {"ward_fr1", "fr3_walking_xyz", "freiburg1_lab", "rgbd_dataset_freiburg12_x"}) {
    const auto named = folder.path() / name;
    std::filesystem::create_directory(named);
    for (const std::string part : {"rgb", "depth", "rgb.txt", "depth.txt"}) {
      std::filesystem::create_symlink(folder.path() / part, named / part);
    }
    EXPECT_THAT([&] { TumFolderSource(named, {}); }, ThrowsMessage<core::InputError>(HasSubstr("--camera"))) << name;
  }
}

TEST(TumFolderSource, SaysWhichOfTumsCamerasItTakesAndWhy) {
  const TumFolder folder(1);
  std::filesystem::remove(folder.path() / "camera.yaml");
  folder.write("groundtruth.txt", "# ground truth trajectory\n# file: 'rgbd_dataset_freiburg1_rpy.bag'\n");
  const Reading reading(folder.path());
  EXPECT_THAT(reading.notes, ElementsAre(AllOf(HasSubstr("freiburg1"), HasSubstr("groundtruth.txt"))));
}

TEST(TumFolderSource, DoesNotGuessTheUnitOfDepth) {
  const TumFolder folder(1);
  folder.write("camera.yaml", "width: 32\nheight: 24\nfx: 30\nfy: 30\ncx: 15.5\ncy: 11.5\n");
  EXPECT_THAT([&] { TumFolderSource(folder.path(), {}); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("camera.yaml"), HasSubstr("depth_factor: 1000"),
                                                    HasSubstr("depth_factor: 5000"), HasSubstr("--depth-factor"))));
  SourceOptions options;
  options.depth_units_per_m = 1000.0;
  EXPECT_FLOAT_EQ(TumFolderSource(folder.path(), options).next()->rangeUnits, 0.001F);
}

TEST(TumFolderSource, AGivenUnitReplacesThatOfTheCameraFile) {
  const TumFolder folder(1);
  SourceOptions options;
  options.depth_units_per_m = 1000.0;
  EXPECT_FLOAT_EQ(TumFolderSource(folder.path(), options).next()->rangeUnits, 0.001F);
}

TEST(TumFolderSource, SaysWhereTheUnitSeemsWrong) {
  const TumFolder folder(6);
  EXPECT_THAT(Reading(folder.path()).notes, IsEmpty());  // about 1 m
  SourceOptions options;
  options.depth_units_per_m = 20000.0;
  EXPECT_THAT(Reading(folder.path(), options).notes,
              ElementsAre(AllOf(HasSubstr("nearer than 0.5 m"), HasSubstr("20000"), HasSubstr("--depth-factor"))));
  options.depth_units_per_m = 500.0;
  EXPECT_THAT(Reading(folder.path(), options).notes, ElementsAre(HasSubstr("farther than 8 m")));
}

TEST(TumFolderSource, TheLargestNumberIsNoMeasurement) {
  const TumFolder folder(1);
  cv::Mat depth = TumFolder::depthImage(0);
  depth.at<std::uint16_t>(5, 5) = 65535;
  depth.at<std::uint16_t>(5, 6) = 65534;
  folder.writeImage(TumFolder::depthFile(0), depth);
  TumFolderSource source(folder.path(), {});
  const auto scan = source.next();
  EXPECT_EQ(scan->rangeImage(5, 5), 0);
  EXPECT_EQ(scan->rangeImage(5, 6), 65534);
}

TEST(TumFolderSource, ReadsFloatingPointDepthAsMetres) {
  const TumFolder folder(1);
  std::filesystem::remove(folder.path() / "camera.yaml");
  folder.write("camera.yaml", "width: 32\nheight: 24\nfx: 30\nfy: 30\ncx: 15.5\ncy: 11.5\n");
  cv::Mat depth(24, 32, CV_32FC1, cv::Scalar(1.5));
  depth.at<float>(0, 0) = std::numeric_limits<float>::quiet_NaN();
  depth.at<float>(0, 1) = std::numeric_limits<float>::infinity();
  depth.at<float>(0, 2) = -1.0F;
  depth.at<float>(0, 3) = 40.0F;  // more than 16 bits hold: no measurement, and no other one
  folder.writeImage("depth/0.tiff", depth);
  folder.write("depth.txt", TumFolder::stamp(TumFolder::depthStamp_s(0)) + " depth/0.tiff\n");
  TumFolderSource source(folder.path(), {});
  const auto scan = source.next();
  ASSERT_TRUE(scan);
  EXPECT_NEAR(scan->rangeImage(5, 5) * static_cast<double>(scan->rangeUnits), 1.5, 1e-6);
  for (int x = 0; x < 4; ++x) EXPECT_EQ(scan->rangeImage(0, x), 0) << x;
}

/// What is said of a floating-point depth image of one value, the first of those that all fail alike.
std::string complaintOfFloatDepth(const cv::Mat& depth, const SourceOptions& options) {
  const TumFolder folder(static_cast<int>(TumFolderSource::kPatience));
  std::string list;
  for (int i = 0; i < static_cast<int>(TumFolderSource::kPatience); ++i) {
    const std::string file = "depth/" + std::to_string(i) + ".tiff";
    folder.writeImage(file, depth);
    list += TumFolder::stamp(TumFolder::depthStamp_s(i)) + " " + file + "\n";
  }
  folder.write("depth.txt", list);
  folder.write("camera.yaml", "width: 32\nheight: 24\nfx: 30\nfy: 30\ncx: 15.5\ncy: 11.5\n");
  TumFolderSource source(folder.path(), options);
  return test::complaintOf([&] { return source.next(); });
}

TEST(TumFolderSource, SaysWhereFloatingPointDepthIsNotInMetres) {
  cv::Mat depth(24, 32, CV_32FC1, cv::Scalar(1500.0));
  depth.rowRange(0, 20).setTo(std::numeric_limits<float>::infinity());
  EXPECT_THAT(complaintOfFloatDepth(depth, {}), AllOf(HasSubstr("above 32"), HasSubstr("divide them by 1000")));
  SourceOptions options;
  options.depth_units_per_m = 1000.0;
  EXPECT_THAT(complaintOfFloatDepth(cv::Mat(24, 32, CV_32FC1, cv::Scalar(1.5)), options), HasSubstr("leave that out"));
}

TEST(TumFolderSource, AsksForTheUnitOfWholeNumbersInTiff) {
  EXPECT_THAT(complaintOfFloatDepth(cv::Mat(24, 32, CV_16UC1, cv::Scalar(1500)), {}),
              AllOf(HasSubstr("holds whole numbers"), HasSubstr("--depth-factor 1000")));
}

// OpenCV was told to read EXR before the first such image was met.
TEST(TumFolderSource, ReadsExrAsMetres) {
  setenv("OPENCV_IO_ENABLE_OPENEXR", "1", 0);  // for writing it here
  const TumFolder folder(1);
  folder.write("camera.yaml", "width: 32\nheight: 24\nfx: 30\nfy: 30\ncx: 15.5\ncy: 11.5\n");
  cv::Mat depth(24, 32, CV_32FC1, cv::Scalar(1.5));
  depth.at<float>(0, 0) = std::numeric_limits<float>::infinity();
  folder.writeImage("depth/0.exr", depth);
  folder.write("depth.txt", TumFolder::stamp(TumFolder::depthStamp_s(0)) + " depth/0.exr\n");
  TumFolderSource source(folder.path(), {});
  const auto scan = source.next();
  ASSERT_TRUE(scan);
  EXPECT_NEAR(scan->rangeImage(5, 5) * static_cast<double>(scan->rangeUnits), 1.5, 1e-6);
  EXPECT_EQ(scan->rangeImage(0, 0), 0);
}

TEST(TumFolderSource, TakesTheCalibrationOfEth3d) {
  const TumFolder folder(1);
  std::filesystem::remove(folder.path() / "camera.yaml");
  folder.write("calibration.txt", "30 31 15.5 11.5\n");
  EXPECT_THAT([&] { TumFolderSource(folder.path(), {}); },
              ThrowsMessage<core::InputError>(HasSubstr("calibration.txt: does not say how many units")));
  SourceOptions options;
  options.depth_units_per_m = 5000.0;
  std::vector<std::string> notes;
  options.note = [&](const std::string& sentence) { notes.push_back(sentence); };
  TumFolderSource source(folder.path(), options);
  const auto scan = source.next();
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->cameraParams.fy(), 31.0);
  EXPECT_THAT(notes, ElementsAre(HasSubstr("numbers alone"), HasSubstr("32x24")));
}

TEST(TumFolderSource, NumbersOfImagesCountAtTheCamerasRate) {
  const TumFolder folder(3);
  folder.write("camera.yaml",
               "width: 32\nheight: 24\nfx: 30\nfy: 30\ncx: 15.5\ncy: 11.5\ndepth_factor: 5000\nfps: 10\n");
  folder.write("associations.txt", "0 rgb/0.png 0 depth/0.png\n1 rgb/1.png 1 depth/1.png\n2 rgb/2.png 2 depth/2.png\n");
  EXPECT_EQ(TumFolderSource(folder.path(), {}).rate_hz(), 10.0);
  const Reading reading(folder.path());
  EXPECT_THAT(reading.stamps_s, ElementsAre(::testing::DoubleNear(0.0, 1e-6), ::testing::DoubleNear(0.1, 1e-6),
                                            ::testing::DoubleNear(0.2, 1e-6)));
  EXPECT_THAT(reading.notes, ElementsAre(AllOf(HasSubstr("associations.txt"), HasSubstr("10 a second"))));
}

TEST(TumFolderSource, StopsWhereTheFirstPairsAllFailAlike) {
  const TumFolder folder(12);
  for (int i = 0; i < 12; ++i) folder.writeImage(TumFolder::depthFile(i), cv::Mat(12, 16, CV_16UC1, cv::Scalar(5000)));
  TumFolderSource source(folder.path(), {});
  EXPECT_THAT([&] { (void)source.next(); },
              ThrowsMessage<core::InputError>(
                  AllOf(HasSubstr("16x12"), HasSubstr("register the depth images"), HasSubstr("first 10 pairs"))));
  EXPECT_FALSE(source.next());
}

TEST(TumFolderSource, GoesOnWhereTheFirstPairsFailForDifferentReasons) {
  const TumFolder folder(12);
  std::filesystem::remove(folder.path() / TumFolder::depthFile(0));
  for (int i = 1; i < 11; ++i) folder.writeImage(TumFolder::depthFile(i), cv::Mat(12, 16, CV_16UC1, cv::Scalar(5000)));
  EXPECT_THAT(Reading(folder.path()).stamps_s, ::testing::SizeIs(1));
}

TEST(TumFolderSource, OrbSlamsCameraHasTheSizeOfTheImages) {
  const TumFolder folder(1);
  folder.write("camera.yaml",
               "%YAML:1.0\n\nCamera.fx: 30.0\nCamera.fy: 31.0\nCamera.cx: 15.5\nCamera.cy: 11.5\n"
               "DepthMapFactor: 1000.0\n");
  const Reading reading(folder.path());
  EXPECT_THAT(reading.stamps_s, ::testing::SizeIs(1));
  EXPECT_THAT(reading.notes, ElementsAre(HasSubstr("calibration of ORB-SLAM"), HasSubstr("32x24")));
}

TEST(TumFolderSource, TellsTheReadoutOfItsCamera) {
  const TumFolder folder(1);
  folder.write("camera.yaml",
               "width: 32\nheight: 24\nfx: 30\nfy: 30\ncx: 15.5\ncy: 11.5\ndepth_factor: 1000\nreadout: 0.02\n");
  EXPECT_EQ(TumFolderSource(folder.path(), {}).sensorTraits().readout_s, 0.02);
}

TEST(TumFolderSource, KnowsTumsCamerasByTheCommentsOfTheList) {
  const TumFolder folder(1);
  std::filesystem::remove(folder.path() / "camera.yaml");
  folder.write("rgb.txt", "# color images\n# file: 'rgbd_dataset_freiburg2_desk.bag'\n100.0 rgb/0.png\n");
  EXPECT_THAT(complaintAboutImageSize(folder.path()), HasSubstr("camera 640x480"));
}

TEST(TumFolderSource, AnUnknownCameraIsAnErrorThatListsTheFiles) {
  const TumFolder folder(1);
  std::filesystem::remove(folder.path() / "camera.yaml");
  EXPECT_THAT([&] { TumFolderSource(folder.path(), {}); },
              ThrowsMessage<core::InputError>(AllOf(HasSubstr("--camera"), HasSubstr("tum_freiburg1.yaml"))));
}

class DamagedTumFolder : public ::testing::Test {
 protected:
  /// Frame 1 of 0..3 is left out, counted and warned of once; the others come.
  void expectLeftOut(const std::string& kind, const std::string& file) const {
    const Reading reading(folder.path());
    EXPECT_THAT(reading.stamps_s, ElementsAre(::testing::DoubleNear(TumFolder::colorStamp_s(0), 1e-6),
                                              ::testing::DoubleNear(TumFolder::colorStamp_s(2), 1e-6),
                                              ::testing::DoubleNear(TumFolder::colorStamp_s(3), 1e-6)));
    EXPECT_THAT(reading.damage, ElementsAre(Pair("sources." + kind, 1)));
    EXPECT_THAT(reading.warnings, ElementsAre(AllOf(HasSubstr("rgb.txt:4: "), HasSubstr(file))));
  }
  TumFolder folder{4};
};

TEST_F(DamagedTumFolder, AMissingColourImageIsLeftOut) {
  std::filesystem::remove(folder.path() / TumFolder::colorFile(1));
  expectLeftOut("image_missing", TumFolder::colorFile(1));
}

TEST_F(DamagedTumFolder, AMissingDepthImageIsLeftOut) {
  std::filesystem::remove(folder.path() / TumFolder::depthFile(1));
  expectLeftOut("image_missing", TumFolder::depthFile(1));
}

TEST_F(DamagedTumFolder, ATruncatedPngIsLeftOutWhereverItIsCut) {
  for (const double part : {0.98, 0.6, 0.3}) {
    test::cutOff(folder.path() / TumFolder::depthFile(1), part);
    expectLeftOut("image_truncated", TumFolder::depthFile(1));
  }
}

TEST_F(DamagedTumFolder, AnEmptyImageFileIsLeftOut) {
  folder.write(TumFolder::colorFile(1), "");
  expectLeftOut("image_truncated", TumFolder::colorFile(1));
}

TEST_F(DamagedTumFolder, WhatIsNoImageIsLeftOut) {
  folder.write(TumFolder::colorFile(1), "this is no image");
  expectLeftOut("image_unreadable", TumFolder::colorFile(1));
}

TEST_F(DamagedTumFolder, APngWithDamagedContentIsLeftOut) {
  std::string bytes = test::readText(folder.path() / TumFolder::depthFile(1));
  for (std::size_t i = 45; i < 65; ++i) bytes[i] = static_cast<char>(~bytes[i]);  // within the compressed pixels
  folder.write(TumFolder::depthFile(1), bytes);
  expectLeftOut("image_unreadable", TumFolder::depthFile(1));
}

TEST_F(DamagedTumFolder, DepthOfAnotherSizeIsLeftOut) {
  folder.writeImage(TumFolder::depthFile(1), cv::Mat(12, 16, CV_16UC1, cv::Scalar(5000)));
  expectLeftOut("depth_size", "16x12");
}

TEST_F(DamagedTumFolder, ColourOfAnotherSizeThanTheCameraIsLeftOut) {
  folder.writeImage(TumFolder::colorFile(1), cv::Mat(12, 16, CV_8UC3, cv::Scalar::all(0)));
  expectLeftOut("image_size", "16x12");
}

TEST_F(DamagedTumFolder, DepthOfEightBitIsLeftOut) {
  folder.writeImage(TumFolder::depthFile(1), cv::Mat(24, 32, CV_8UC1, cv::Scalar(50)));
  expectLeftOut("depth_format", TumFolder::depthFile(1));
}

TEST(TumFolderSource, ATruncatedJpegIsLeftOut) {
  const TumFolder folder(2, "jpg");
  test::cutOff(folder.path() / TumFolder::colorFile(0, "jpg"), 0.9);
  const Reading reading(folder.path());
  EXPECT_THAT(reading.stamps_s, ::testing::SizeIs(1));
  EXPECT_THAT(reading.damage, ElementsAre(Pair("sources.image_truncated", 1)));
}

TEST(TumFolderSource, EachKindOfDamageIsToldOnceAndCountedAlways) {
  const TumFolder folder(5);
  for (const int i : {0, 2, 3}) std::filesystem::remove(folder.path() / TumFolder::depthFile(i));
  const Reading reading(folder.path());
  EXPECT_THAT(reading.damage, ElementsAre(Pair("sources.image_missing", 3)));
  EXPECT_THAT(reading.warnings, ::testing::SizeIs(1));
  EXPECT_THAT(reading.stamps_s, ::testing::SizeIs(2));
}

}  // namespace
}  // namespace wardslam::sources
