// Recordings of other programs: see ../bags/make_data/README.md.
#include "wardslam/sources/bag_observations.h"

#include <gmock/gmock.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>

#include <map>
#include <opencv2/core.hpp>
#include <vector>

#include "support/complaint.h"
#include "support/temporary_folder.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::sources {
namespace {

using mrpt::obs::CObservation3DRangeScan;
using mrpt::obs::CObservationIMU;
using mrpt::obs::CObservationOdometry;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::filesystem::path data(const std::string& name) { return std::filesystem::path(WARDSLAM_BAGS_DATA) / name; }

struct Read {
  std::vector<std::shared_ptr<CObservation3DRangeScan>> scans;
  std::vector<std::shared_ptr<CObservationOdometry>> odometries;
  std::vector<std::shared_ptr<CObservationIMU>> imus;
  std::vector<std::string> notes;
  core::EventCounts damage;
};

Read readAll(const std::string& name, SourceOptions options = {}) {
  Read read;
  options.note = [&](const std::string& sentence) { read.notes.push_back(sentence); };
  BagObservations bag(data(name), options);
  double last_s = 0.0;
  while (const auto observation = bag.next()) {
    const double stamp_s = core::fromMrptTime(observation->timestamp);
    EXPECT_GE(stamp_s, last_s);
    last_s = stamp_s;
    if (auto scan = std::dynamic_pointer_cast<CObservation3DRangeScan>(observation)) read.scans.push_back(scan);
    if (auto odometry = std::dynamic_pointer_cast<CObservationOdometry>(observation))
      read.odometries.push_back(odometry);
    if (auto imu = std::dynamic_pointer_cast<CObservationIMU>(observation)) read.imus.push_back(imu);
  }
  read.damage = bag.damage();
  return read;
}

TEST(BagObservations, OneRecordingIsTheSameInAllKinds) {
  const Read first = readAll("none.bag");
  ASSERT_EQ(first.scans.size(), 3U);
  for (const char* name : {"bz2.bag", "lz4.bag", "compressed.bag", "none.mcap", "zstd.mcap", "lz4.mcap",
                           "no_index.mcap", "unchunked.mcap", "sqlite", "sqlite_zstd"}) {
    const Read other = readAll(name);
    EXPECT_TRUE(other.damage.empty()) << name;
    ASSERT_EQ(other.scans.size(), 3U) << name;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(other.scans[i]->timestamp, first.scans[i]->timestamp) << name;
      EXPECT_EQ(other.scans[i]->rangeImage, first.scans[i]->rangeImage) << name;
      const cv::Mat& a = other.scans[i]->intensityImage.asCvMatRef();
      const cv::Mat& b = first.scans[i]->intensityImage.asCvMatRef();
      EXPECT_EQ(cv::norm(a, b, cv::NORM_INF), 0.0) << name;
      EXPECT_EQ(other.scans[i]->cameraParams, first.scans[i]->cameraParams) << name;
    }
  }
}

TEST(BagObservations, AUnitThatIsGivenReplacesMillimetresButNotMetres) {
  SourceOptions options;
  EXPECT_FLOAT_EQ(readAll("none.bag", options).scans.at(0)->rangeUnits, 0.001F);
  options.depth_units_per_m = 4000.0;
  EXPECT_FLOAT_EQ(readAll("none.bag", options).scans.at(0)->rangeUnits, 0.00025F);
  EXPECT_FLOAT_EQ(readAll("float.mcap", options).scans.at(0)->rangeUnits, 0.0002F);
}

TEST(BagObservations, ScansSayWhereTheCameraSits) {
  for (const char* name : {"none.bag", "none.mcap", "sqlite"}) {
    const Read read = readAll(name);
    ASSERT_FALSE(read.scans.empty());
    const CObservation3DRangeScan& scan = *read.scans.front();
    EXPECT_EQ(scan.sensorLabel, "/camera/color/image_raw");
    EXPECT_FLOAT_EQ(scan.rangeUnits, 0.001F);
    EXPECT_EQ(scan.cameraParams.fx(), 52.5);
    EXPECT_EQ(scan.rangeImage(5, 10), 1100);
    EXPECT_TRUE(scan.doDepthAndIntensityCamerasCoincide());
    // base_link to the optical frame: 0.25 m forward, 1.5 m up, looking forward.
    const mrpt::poses::CPose3D& pose = scan.sensorPose;
    EXPECT_NEAR(pose.x(), 0.25, 1e-9);
    EXPECT_NEAR(pose.y(), 0.0, 1e-9);
    EXPECT_NEAR(pose.z(), 1.5, 1e-9);
    EXPECT_NEAR(pose.yaw(), 0.0, 1e-9);
    EXPECT_NEAR(pose.pitch(), 0.0, 1e-9);
    EXPECT_NEAR(pose.roll(), 0.0, 1e-9);
    EXPECT_THAT(read.notes, ElementsAre(AllOf(HasSubstr("colour from /camera/color/image_raw"),
                                              HasSubstr("depth from /camera/aligned_depth_to_color/image_raw"),
                                              HasSubstr("'base_link'"))));
  }
}

// Depth was seen by a camera of its own, 15 mm beside, in units of 0.1 mm.
TEST(BagObservations, ReadsWhatRealSensesOwnRecorderWrites) {
  for (const char* name : {"realsense.bag", "realsense.db3"}) {
    const Read read = readAll(name);
    ASSERT_EQ(read.scans.size(), 3U) << name;
    EXPECT_TRUE(read.damage.empty()) << name;
    const CObservation3DRangeScan& scan = *read.scans.front();
    EXPECT_EQ(scan.sensorLabel, "/device_0/sensor_1/Color_0/image/data");
    EXPECT_FLOAT_EQ(scan.rangeUnits, 0.0001F);
    EXPECT_EQ(scan.rangeImage(5, 10), 1100);
    EXPECT_EQ(scan.cameraParams.fx(), 50.0);
    EXPECT_EQ(scan.cameraParamsIntensity.fx(), 52.5);
    // In MRPT's sensor frame, whose -y is the camera's x: a colour camera to the right of that of depth.
    EXPECT_NEAR(scan.relativePoseIntensityWRTDepth.y(), -0.015, 1e-7);
    EXPECT_NEAR(scan.relativePoseIntensityWRTDepth.x(), 0.0, 1e-7);
    EXPECT_THAT(read.notes, Contains(AllOf(HasSubstr("depth from /device_0/sensor_0/Depth_0/image/data"),
                                           HasSubstr("depth is registered here, by the transforms recorded"))));
    SourceOptions options;
    options.depth_units_per_m = 1000.0;
    EXPECT_FLOAT_EQ(readAll(name, options).scans.at(0)->rangeUnits, 0.001F) << name;
  }
}

TEST(BagObservations, HasOdometryAndInertia) {
  const Read read = readAll("none.mcap");
  ASSERT_EQ(read.odometries.size(), 3U);
  const CObservationOdometry& odometry = *read.odometries.back();
  EXPECT_NEAR(odometry.odometry.x(), 1.0, 1e-12);
  EXPECT_NEAR(odometry.odometry.phi(), 2 * std::atan2(0.6, 0.8), 1e-12);
  EXPECT_TRUE(odometry.hasVelocities);
  EXPECT_EQ(odometry.velocityLocal.vx, 0.25);
  EXPECT_EQ(odometry.velocityLocal.omega, -0.125);
  ASSERT_EQ(read.imus.size(), 3U);
  EXPECT_EQ(read.imus[0]->get(mrpt::obs::IMU_Z_ACC), 9.75);
  EXPECT_EQ(read.imus[0]->get(mrpt::obs::IMU_WY), 0.5);
  EXPECT_FALSE(read.imus[0]->has(mrpt::obs::IMU_ORI_QUAT_W));
}

TEST(BagObservations, MetresAreStepsOfAFifthOfAMillimetre) {
  const Read read = readAll("float.mcap");
  ASSERT_EQ(read.scans.size(), 3U);
  EXPECT_FLOAT_EQ(read.scans[0]->rangeUnits, 0.0002F);
  EXPECT_EQ(read.scans[0]->rangeImage(5, 10), 5500);
  EXPECT_EQ(read.scans[0]->rangeImage(5, 1), 0);
}

TEST(BagObservations, SaysWhichUnitDoesNotCount) {
  SourceOptions options;
  options.depth_units_per_m = 1000.0;
  EXPECT_THAT(readAll("float.mcap", options).notes, Contains(HasSubstr("--depth-factor does not change")));
  const test::TemporaryFolder folder;
  options = {};
  options.camera = folder.write("camera.yaml",
                                "width: 64\nheight: 48\nfx: 52.5\nfy: 52.5\ncx: 31.5\ncy: 23.5\ndepth_factor: 5000\n");
  EXPECT_THAT(readAll("none.mcap", options).notes,
              Contains(AllOf(HasSubstr("1000 units a metre"), HasSubstr("not 5000, as the camera file says"))));
}

TEST(BagObservations, SaysAsWhatAForeignCameraFileIsRead) {
  const test::TemporaryFolder folder;
  SourceOptions options;
  options.camera = folder.write("camchain.yaml",
                                "cam0:\n  camera_model: pinhole\n  intrinsics: [52.5, 52.5, 31.5, 23.5]\n"
                                "  resolution: [64, 48]\n");
  EXPECT_THAT(readAll("none.mcap", options).notes, Contains(HasSubstr("Kalibr")));
  options.camera = folder.write("intrinsic.txt", "52.5 52.5 31.5 23.5\n");
  EXPECT_THAT(test::complaintOf([&] { return readAll("none.mcap", options).scans; }),
              HasSubstr("does not tell the size of the images"));
}

TEST(BagObservations, ARecordingThatWasCutOffIsReadAndCounted) {
  const Read read = readAll("unclosed.bag");
  EXPECT_EQ(read.scans.size(), 2U);
  EXPECT_EQ(read.damage.at("sources.bag_truncated"), 1U);
}

}  // namespace
}  // namespace wardslam::sources
