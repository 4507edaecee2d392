// What the program writes with the options of camera and sensors.
#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/serialization/CArchive.h>

#include <cstdlib>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "support/temporary_folder.h"
#include "wardslam/core/camera_model.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/exchange/tum_trajectory.h"
#include "wardslam/sources/observation_source.h"

namespace wardslam {
namespace {

namespace fs = std::filesystem;
using Scan = mrpt::obs::CObservation3DRangeScan;
using Observations = std::vector<mrpt::obs::CObservation::Ptr>;

class RawlogSynthRecording : public testing::Test {
 protected:
  /// The program's exit code; small pictures.
  [[nodiscard]] int run(const std::string& output, const std::string& arguments) const {
    const std::string command = "ASAN_OPTIONS=detect_leaks=0 " RAWLOG_SYNTH " --width 160 --height 120 -o " +
                                file(output).string() + " " + arguments + " >/dev/null 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));  // NOLINT(cert-env33-c)
  }
  [[nodiscard]] Observations record(const std::string& arguments) const {
    EXPECT_EQ(run("w.rawlog", arguments), 0);
    mrpt::io::CFileGZInputStream stream(file("w.rawlog").string());
    auto archive = mrpt::serialization::archiveFrom(stream);
    Observations observations;
    try {
      while (true) observations.push_back(std::dynamic_pointer_cast<mrpt::obs::CObservation>(archive.ReadObject()));
    } catch (const std::exception&) {  // the end of a gz stream is noticed by reading past it
    }
    return observations;
  }
  template <class Kind>
  [[nodiscard]] static std::vector<std::shared_ptr<Kind>> only(const Observations& observations) {
    std::vector<std::shared_ptr<Kind>> some;
    for (const auto& observation : observations) {
      if (auto one = std::dynamic_pointer_cast<Kind>(observation)) some.push_back(one);
    }
    return some;
  }
  [[nodiscard]] fs::path file(const std::string& name) const { return folder_.path() / name; }
  [[nodiscard]] cv::Mat label(const std::string& kind, const std::string& stamp) const {
    return cv::imread(file("w_labels/" + kind + "/" + stamp + ".png").string(), cv::IMREAD_UNCHANGED);
  }

 private:
  test::TemporaryFolder folder_;
};

double brightness(const Scan& scan) {
  const cv::Scalar mean = cv::mean(scan.intensityImage.asCvMatRef());
  return (mean[0] + mean[1] + mean[2]) / 3;
}

int measuredPixels(const Scan& scan) {
  return cv::countNonZero(cv::Mat(scan.rangeImage.rows(), scan.rangeImage.cols(), CV_16UC1,
                                  const_cast<std::uint16_t*>(scan.rangeImage.data())));  // NOLINT: it is only read
}

TEST_F(RawlogSynthRecording, SaysHowTheCameraIsMounted) {
  const auto scans =
      only<Scan>(record("--seconds 0.1 --rate 10 --camera-height 0.6 --camera-pitch -20 --camera-roll 5"));
  ASSERT_EQ(scans.size(), 1U);
  const auto& pose = scans[0]->sensorPose;
  EXPECT_NEAR(pose.z(), 0.6, 1e-9);
  EXPECT_NEAR(pose.pitch(), -20 * M_PI / 180, 1e-9);
  EXPECT_NEAR(pose.roll(), 5 * M_PI / 180, 1e-9);
  // The base under the true camera stands on the floor, all but level.
  const auto truth = exchange::readTumTrajectory(file("w.groundtruth.txt"));
  const Eigen::Isometry3d T_world_base =
      truth[0].T_map_cam * core::T_sensor_cam().inverse() * core::fromMrpt(pose).inverse();
  EXPECT_NEAR(T_world_base.translation().z(), 0.0, 0.03);
  EXPECT_GT(T_world_base.linear()(2, 2), std::cos(0.08));
}

TEST_F(RawlogSynthRecording, CarriesTheLensInTheCamerasParameters) {
  const auto scans = only<Scan>(record("--seconds 0.1 --rate 10 --lens wide"));
  ASSERT_EQ(scans.size(), 1U);
  EXPECT_EQ(core::fromMrpt(scans[0]->cameraParamsIntensity).k1, -0.28);
  EXPECT_EQ(core::fromMrpt(scans[0]->cameraParams).k2, 0.07);
  EXPECT_EQ(scans[0]->intensityImage.getWidth(), 160U);
  EXPECT_EQ(scans[0]->rangeImage.cols(), 160);
}

TEST_F(RawlogSynthRecording, InTheDarkThereIsDepthAndNoLight) {
  const auto scans = only<Scan>(record("--seconds 0.1 --rate 10 --dark"));
  EXPECT_LT(brightness(*scans.at(0)), 10.0);
  EXPECT_GT(measuredPixels(*scans.at(0)), 160 * 120 / 2);
}

TEST_F(RawlogSynthRecording, MotionBlursTheImage) {
  // Steepness of the image, which a smear takes away.
  const auto steepness = [](const Scan& scan) {
    const cv::Mat image = scan.intensityImage.asCvMatRef();
    return cv::norm(image.colRange(1, 160), image.colRange(0, 159), cv::NORM_L1);
  };
  const std::string still = "--seconds 0.1 --rate 10 --image-noise 0 --motion-blur ";
  const double sharp = steepness(*only<Scan>(record(still + "0")).at(0));
  const double blurred = steepness(*only<Scan>(record(still + "120")).at(0));
  EXPECT_LT(blurred, 0.9 * sharp);
}

TEST_F(RawlogSynthRecording, AHandHidesTheLensWhileTheTruthGoesOn) {
  const auto scans = only<Scan>(record("--seconds 3 --rate 1 --cover 0.5:1"));
  ASSERT_EQ(scans.size(), 3U);
  EXPECT_GT(brightness(*scans[0]), 40.0);
  EXPECT_LT(brightness(*scans[1]), 12.0);
  EXPECT_GT(brightness(*scans[2]), 40.0);
  EXPECT_EQ(measuredPixels(*scans[1]), 0);
  EXPECT_EQ(exchange::readTumTrajectory(file("w.groundtruth.txt")).size(), 3U);
  EXPECT_EQ(cv::countNonZero(label("masks", "1700000001.000000")), 0);
  EXPECT_EQ(cv::countNonZero(label("dynamic", "1700000001.000000")), 160 * 120);
  EXPECT_GT(cv::countNonZero(label("masks", "1700000002.000000")), 0);
}

TEST_F(RawlogSynthRecording, LostFramesAreMissingEverywhereButInTheTruth) {
  const auto scans = only<Scan>(record("--seconds 3 --rate 10 --drop 0.5"));
  EXPECT_LT(scans.size(), 26U);
  EXPECT_GT(scans.size(), 4U);
  EXPECT_EQ(exchange::readTumTrajectory(file("w.groundtruth.txt")).size(), 30U);
  std::size_t masks = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(file("w_labels/masks"))) ++masks;
  EXPECT_EQ(masks, scans.size());
}

TEST_F(RawlogSynthRecording, WheelsAndInertialSensorComeInOrderOfTime) {
  const auto all = record("--seconds 1 --rate 10 --odometry --imu 50");
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_LE(all[i - 1]->timestamp, all[i]->timestamp);
  EXPECT_EQ(only<Scan>(all).size(), 10U);
  const auto odometry = only<mrpt::obs::CObservationOdometry>(all);
  const auto imu = only<mrpt::obs::CObservationIMU>(all);
  EXPECT_EQ(odometry.size(), 19U) << "20 Hz until the last picture at 0.9 s";
  EXPECT_EQ(imu.size(), 46U);
  EXPECT_GT(odometry.back()->odometry.norm(), 0.1);
  EXPECT_TRUE(odometry.back()->hasVelocities);
  EXPECT_TRUE(imu.front()->dataIsPresent[mrpt::obs::IMU_WZ]);
  EXPECT_NEAR(imu.front()->rawMeasurements[mrpt::obs::IMU_Z_ACC], 9.81, 1.0);
  const auto& mount = only<Scan>(all).front()->sensorPose;
  EXPECT_NEAR(mount.pitch(), 0.10, 1e-9) << "it looks down as it does";
  EXPECT_LT((imu.front()->sensorPose - mount).norm(), 1e-9);
}

TEST_F(RawlogSynthRecording, AFolderIsOneOfTheTumLayout) {
  ASSERT_EQ(run("tum", "--seconds 0.3 --rate 10 --lens kinect --odometry --imu --depth-noise 0"), 0);
  const auto source = sources::openSource(file("tum"), {});
  EXPECT_EQ(source->size(), 3U);
  const auto scan = source->next();
  ASSERT_TRUE(scan);
  EXPECT_EQ(core::fromMrpt(scan->cameraParamsIntensity).k1, 0.2624);
  EXPECT_NEAR(core::fromMrptTime(scan->timestamp), 1700000000.0, 1e-6);
  EXPECT_GT(brightness(*scan), 40.0);
  const cv::Mat depth = cv::imread(file("tum/depth/1700000000.000000.png").string(), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(depth.type(), CV_16UC1);
  const double middle_m = depth.at<std::uint16_t>(60, 80) / 5000.0;
  EXPECT_GT(middle_m, 0.4);
  EXPECT_LT(middle_m, 8.0);
  EXPECT_EQ(exchange::readTumTrajectory(file("tum/groundtruth.txt")).size(), 3U);
  for (const char* name : {"tum/odometry.txt", "tum/imu.txt", "tum_labels/objects.csv", "tum_labels/masks"}) {
    EXPECT_TRUE(fs::exists(file(name))) << name;
  }
  EXPECT_FALSE(fs::exists(file("tum.partial")));
  EXPECT_EQ(run("tum", "--seconds 0.1"), 1) << "it is there already";
}

TEST_F(RawlogSynthRecording, TheNameOrTheUserSaysWhatIsWritten) {
  EXPECT_EQ(run("ward.1", "--seconds 0.1 --rate 10"), 2) << "neither rawlog nor folder";
  EXPECT_EQ(run("ward.1", "--seconds 0.1 --rate 10 --tum"), 0);
  EXPECT_TRUE(fs::exists(file("ward.1/rgb.txt")));
  EXPECT_TRUE(fs::exists(file("ward.1_labels")));
  EXPECT_EQ(run("pair", "--stereo --seconds 0.1"), 2) << "no stereo pairs in that layout";
}

TEST_F(RawlogSynthRecording, RefusesWhatIsNoCameraInOneSentence) {
  for (const char* wrong : {"--lens fish", "--cover 3", "--cover nan:1", "--drop 1", "--drop nan", "--rate nan",
                            "--depth-sensor sonar", "--imu-noise 2"}) {
    EXPECT_EQ(run("w.rawlog", std::string("--seconds 0.1 ") + wrong), 2) << wrong;
  }
}

}  // namespace
}  // namespace wardslam
