#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/temporary_folder.h"
#include "wardslam/core/camera_model.h"
#include "wardslam/core/label_space.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/exchange/tum_trajectory.h"

namespace wardslam {
namespace {

namespace fs = std::filesystem;
using Scan = mrpt::obs::CObservation3DRangeScan;

/// The program's exit code.
int run(const std::string& arguments, const std::string& environment = "") {
  const std::string command =
      "ASAN_OPTIONS=detect_leaks=0 " + environment + " " RAWLOG_SYNTH " " + arguments + " >/dev/null 2>&1";
  return WEXITSTATUS(std::system(command.c_str()));  // NOLINT(cert-env33-c)
}

std::vector<Scan::Ptr> readRawlog(const fs::path& file) {
  mrpt::io::CFileGZInputStream stream(file.string());
  auto archive = mrpt::serialization::archiveFrom(stream);
  std::vector<Scan::Ptr> scans;
  while (!stream.checkEOF()) {
    mrpt::serialization::CSerializable::Ptr object;
    try {
      archive >> object;
    } catch (const std::exception&) {
      break;  // the end of a gz stream is noticed by reading past it
    }
    scans.push_back(std::dynamic_pointer_cast<Scan>(object));
  }
  return scans;
}

/// Every file below the folder with its bytes.
std::map<std::string, std::string> contentOf(const fs::path& folder) {
  std::map<std::string, std::string> content;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ostringstream bytes;
    bytes << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    content[fs::relative(entry.path(), folder).string()] = bytes.str();
  }
  return content;
}

TEST(RawlogSynth, SameArgumentsGiveTheSameBytes) {
  const test::TemporaryFolder folder;
  const std::string size = " --seconds 0.1 --width 320 --height 240";
  for (const char* name : {"a", "b", "c"}) fs::create_directory(folder.path() / name);
  ASSERT_EQ(run("-o " + (folder.path() / "a/ward.rawlog").string() + size), 0);
  ASSERT_EQ(run("-o " + (folder.path() / "b/ward.rawlog").string() + size), 0);
  ASSERT_EQ(run("-o " + (folder.path() / "c/ward.rawlog").string() + size + " --seed 2"), 0);
  const auto content = contentOf(folder.path() / "a");
  EXPECT_EQ(content.size(), 16U)
      << "rawlog, ground truth, 3 x 3 label images, classes, objects, rests, floor plan in two files";
  EXPECT_TRUE(content == contentOf(folder.path() / "b"));
  EXPECT_FALSE(content == contentOf(folder.path() / "c"));
}

class SynthesisedWard : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(run("-o " + file("ward.rawlog").string() + " --seconds 0.3 --rate 10"), 0); }
  [[nodiscard]] fs::path file(const std::string& name) const { return folder_.path() / name; }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(SynthesisedWard, IsARawlogOfRegisteredColourAndDepth) {
  const auto scans = readRawlog(file("ward.rawlog"));
  ASSERT_EQ(scans.size(), 3U);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const Scan& scan = *scans[i];
    EXPECT_EQ(scan.sensorLabel, "RGBD");
    EXPECT_NEAR(core::fromMrptTime(scan.timestamp), 1700000000.0 + 0.1 * static_cast<double>(i), 1e-6);
    EXPECT_TRUE(scan.hasIntensityImage && scan.hasRangeImage && scan.range_is_depth);
    EXPECT_TRUE(scan.doDepthAndIntensityCamerasCoincide());
    EXPECT_EQ(scan.intensityImage.getWidth(), 640U);
    EXPECT_EQ(scan.intensityImage.channelCount(), 3U);
    EXPECT_EQ(scan.rangeImage.rows(), 480);
    EXPECT_EQ(scan.cameraParamsIntensity.fx(), 525.0);
    EXPECT_EQ(scan.cameraParamsIntensity.cx(), 319.5);
    const double middle_m = scan.rangeImage(240, 320) * static_cast<double>(scan.rangeUnits);
    EXPECT_GT(middle_m, 0.4);
    EXPECT_LT(middle_m, 8.0);
  }
}

TEST_F(SynthesisedWard, HasAPoseAndLabelsForEveryStamp) {
  const auto truth = exchange::readTumTrajectory(file("ward.groundtruth.txt"));
  ASSERT_EQ(truth.size(), 3U);
  const auto labels = core::LabelSpace::cocoWith(file("ward_labels/classes.txt"));
  EXPECT_EQ(labels.find("trolley"), core::ClassId{102});
  for (const auto& pose : truth) {
    std::ostringstream name;
    name << std::fixed << std::setprecision(6) << pose.stamp_s << ".png";
    const cv::Mat mask = cv::imread(file("ward_labels/masks/" + name.str()).string(), cv::IMREAD_UNCHANGED);
    const cv::Mat instances = cv::imread(file("ward_labels/instances/" + name.str()).string(), cv::IMREAD_UNCHANGED);
    const cv::Mat dynamic = cv::imread(file("ward_labels/dynamic/" + name.str()).string(), cv::IMREAD_UNCHANGED);
    ASSERT_EQ(mask.type(), CV_8UC1);
    ASSERT_EQ(instances.type(), CV_16UC1);
    ASSERT_EQ(dynamic.type(), CV_8UC1);
    EXPECT_EQ(mask.size(), cv::Size(640, 480));
    EXPECT_EQ(cv::countNonZero((mask != 0) != (instances != 0)), 0);
    EXPECT_GT(cv::countNonZero(mask == 1), 500) << "people";
    EXPECT_GT(cv::countNonZero(mask == 60), 500) << "beds";
    EXPECT_EQ(cv::countNonZero((dynamic != 0) & (mask != 1) & (mask != 102)), 0) << "only people and the trolley move";
  }
}

TEST_F(SynthesisedWard, ReplacesItsOwnOutput) {
  const std::string again = "-o " + file("ward.rawlog").string() + " --seconds 0.1 --rate 10 --no-people";
  ASSERT_EQ(run(again), 0);
  EXPECT_EQ(readRawlog(file("ward.rawlog")).size(), 1U);
  const auto names = contentOf(file("."));
  EXPECT_EQ(names.size(), 10U) << "nothing of the longer sequence is left, nothing partial";
}

TEST_F(SynthesisedWard, DepthAgreesBetweenFramesByTheGroundTruth) {
  const auto scans = readRawlog(file("ward.rawlog"));
  const auto truth = exchange::readTumTrajectory(file("ward.groundtruth.txt"));
  const core::CameraModel camera = core::fromMrpt(scans[0]->cameraParamsIntensity);
  const Eigen::Isometry3d T_b_a = truth[2].T_map_cam.inverse() * truth[0].T_map_cam;
  std::vector<double> errors_sigma;
  for (int y = 4; y < 480; y += 4) {
    for (int x = 4; x < 640; x += 4) {
      const double z_m = scans[0]->rangeImage(y, x) * 0.001;
      if (z_m == 0) continue;
      const Eigen::Vector3d p = T_b_a * camera.unproject(Eigen::Vector2d(x, y), z_m);
      const Eigen::Vector2d pixel = camera.project(p).array().round();
      if (pixel.minCoeff() < 0 || pixel.x() > 639 || pixel.y() > 479) continue;
      const double measured_m = scans[2]->rangeImage(static_cast<int>(pixel.y()), static_cast<int>(pixel.x())) * 0.001;
      if (measured_m > 0)
        errors_sigma.push_back(std::abs(measured_m - p.z()) / (0.0012 + 0.0019 * std::pow(p.z() - 0.4, 2)));
    }
  }
  ASSERT_GT(errors_sigma.size(), 5000U);
  const auto middle = errors_sigma.begin() + static_cast<std::ptrdiff_t>(errors_sigma.size() / 2);
  std::nth_element(errors_sigma.begin(), middle, errors_sigma.end());
  // Two independent errors, each with the disparity's rounding on top: 0.67 sqrt(2) sqrt(1.3) sigma.
  EXPECT_LT(*middle, 1.35);
}

TEST(RawlogSynth, EmptyWardHasTheTrolleyAmongItsObjects) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(run("-o " + (folder.path() / "w.rawlog").string() + " --seconds 0.03 --no-people"), 0);
  std::ifstream objects(folder.path() / "w_labels/objects.csv");
  std::string line;
  std::getline(objects, line);
  EXPECT_EQ(line, "instance_id,name,class_id,class_name,cx,cy,cz,xmin,ymin,zmin,xmax,ymax,zmax,static_from_s");
  std::map<std::string, int> counts;
  while (std::getline(objects, line)) {
    std::istringstream fields(line);
    std::string field;
    for (int i = 0; i < 4; ++i) std::getline(fields, field, ',');
    ++counts[field];
  }
  EXPECT_EQ(counts["bed"], 5);
  EXPECT_EQ(counts["trolley"], 1);
  EXPECT_GE(counts["chair"], 4);
  EXPECT_EQ(counts.count("person"), 0U);
}

TEST(RawlogSynth, RendersAFloorFromWhereItsRoundBegins) {
  const test::TemporaryFolder folder;
  const std::string size = " --rate 10 --width 160 --height 120";
  ASSERT_EQ(run("--scene floor --seconds 0.2 -o " + (folder.path() / "f.rawlog").string() + size), 0);
  EXPECT_EQ(readRawlog(folder.path() / "f.rawlog").size(), 2U);
  const auto truth = exchange::readTumTrajectory(folder.path() / "f.groundtruth.txt");
  EXPECT_TRUE(truth.front().T_map_cam.translation().head<2>().isApprox(Eigen::Vector2d(9.0, 1.5), 1e-6));
}

TEST(RawlogSynth, WrongArgumentsAreUsageErrors) {
  EXPECT_EQ(run(""), 2);
  EXPECT_EQ(run("-o ward.bag"), 2);
  EXPECT_EQ(run("-o w.rawlog --seconds -3"), 2);
  EXPECT_EQ(run("-o w.rawlog --widht 640"), 2);
  EXPECT_EQ(run("-o /nonexistent/folder/w.rawlog --seconds 0.1"), 1);
  EXPECT_EQ(run("-o w.rawlog --scene garden"), 2);
  EXPECT_EQ(run("--help"), 0);
}

TEST(RawlogSynth, TakesNamesAndNotTheirNumbers) {
  const test::TemporaryFolder folder;
  const std::string shortly = "-o " + (folder.path() / "w.rawlog").string() + " --seconds 0.03 --width 64 --height 48 ";
  EXPECT_EQ(run(shortly + "--lens wide --depth-sensor tof --route lobby"), 0);
  for (const char* choice : {"--lens 2", "--lens fish", "--depth-sensor 0", "--route 4", "--route Lobby"})
    EXPECT_EQ(run(shortly + choice), 2) << choice;
}

TEST(RawlogSynth, LeavesForeignFoldersAlone) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder.path() / "w_labels");
  std::ofstream(folder.path() / "w_labels/thesis.txt") << "mine";
  EXPECT_EQ(run("-o " + (folder.path() / "w.rawlog").string() + " --seconds 0.03"), 1);
  EXPECT_TRUE(fs::exists(folder.path() / "w_labels/thesis.txt"));
  EXPECT_EQ(contentOf(folder.path()).size(), 1U) << "nothing was added";
}

TEST(RawlogSynth, RendersWhereThereIsNoOpenGl) {
  const test::TemporaryFolder folder;
  const std::string output = (folder.path() / "w.rawlog").string();
  EXPECT_EQ(run("-o " + output + " --seconds 0.03 --width 64 --height 48", "__EGL_VENDOR_LIBRARY_DIRS=/nonexistent"),
            0);
  EXPECT_EQ(readRawlog(output).size(), 1U);
}

}  // namespace
}  // namespace wardslam
