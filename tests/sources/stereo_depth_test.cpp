#include "stereo_depth.h"

#include <gmock/gmock.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>

#include "sources/stereo_pair_maker.h"
#include "wardslam/core/errors.h"
#include "wardslam/sources/frame_builder.h"

namespace wardslam::sources {
namespace {

using test::StereoScene;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

core::Frame frameOf(const StereoScene& scene, const StereoOptions& options = {}) {
  return FrameBuilder().build(StereoDepth(options).convert(*scene.record()));
}

double shareWithDepth(const cv::Mat& depth_m) {
  return cv::countNonZero(depth_m) / static_cast<double>(depth_m.total());
}

void expectError(const mrpt::obs::CObservationStereoImages& pair, const std::string& what) {
  StereoDepth stereo({});
  EXPECT_THAT([&] { return stereo.convert(pair); }, ThrowsMessage<core::FrameError>(HasSubstr(what)));
}

TEST(StereoDepth, OfAFrontalWallIsItsDistance) {
  const core::Frame frame = frameOf({});  // 2 m: 12.5 px of disparity
  const cv::Mat seenByBoth = frame.depth_m.colRange(20, 300).rowRange(10, 230);
  EXPECT_GT(shareWithDepth(seenByBoth), 0.97);
  cv::Scalar mean_m;
  cv::Scalar deviation_m;
  cv::meanStdDev(seenByBoth, mean_m, deviation_m, seenByBoth > 0);
  EXPECT_NEAR(mean_m[0], 2.0, 0.01);
  EXPECT_LT(deviation_m[0], 0.05) << "a quarter of a pixel is 4 cm";
  EXPECT_LT(shareWithDepth(frame.depth_m.colRange(0, 8)), 0.05) << "the right camera does not see that";
}

TEST(StereoDepth, FollowsASlantedWall) {
  StereoScene scene;
  scene.wall = Eigen::Hyperplane<double, 3>(Eigen::Vector3d(-0.5, 0, 1).normalized(), Eigen::Vector3d(0, 0, 2));
  const core::Frame frame = frameOf(scene);
  // z = 2 m + x / 2, and x = z (u - 159.5) / 250: z = 2 m / (1 - (u - 159.5) / 500).
  for (const auto& [column, z_m] : {std::pair(60, 2.0 / 1.199), {110, 2.0 / 1.099}, {160, 2.0 / 0.999}, {260, 2.5}}) {
    const cv::Mat strip = frame.depth_m.colRange(column - 1, column + 2);
    EXPECT_NEAR(cv::mean(strip, strip > 0)[0], z_m, 0.03) << column;
  }
}

TEST(StereoDepth, KeepsWhatAnRgbdCameraWouldHaveRecorded) {
  auto pair = StereoScene().record(3);
  pair->cameraPose = mrpt::poses::CPose3DQuat(mrpt::poses::CPose3D(0.2, 0, 1.1) + core::toMrpt(core::T_sensor_cam()));
  const auto scan = StereoDepth({}).convert(*pair);
  EXPECT_EQ(scan->timestamp, pair->timestamp);
  EXPECT_EQ(scan->sensorLabel, "STEREO");
  EXPECT_EQ(scan->intensityImage.asCvMatRef().data, pair->imageLeft.asCvMatRef().data);
  const core::Frame frame = FrameBuilder().build(scan);
  EXPECT_EQ(frame.camera, StereoScene::camera());
  EXPECT_TRUE(frame.T_base_cam.translation().isApprox(Eigen::Vector3d(0.2, 0, 1.1)));
  EXPECT_TRUE((frame.T_base_cam.linear() * Eigen::Vector3d::UnitZ()).isApprox(Eigen::Vector3d::UnitX()));
}

TEST(StereoDepth, GrowsUnsureWithTheSquareOfTheDepth) {
  StereoOptions options;
  options.disparity_sigma_px = 0.5;
  StereoDepth stereo(options);
  static_cast<void>(stereo.convert(*StereoScene().record()));
  EXPECT_NEAR(stereo.noise().sigma_m(1.0), 0.02, 1e-9);  // 1² / 25 x 0.5
  EXPECT_NEAR(stereo.noise().sigma_m(5.0), 0.5, 1e-9);
}

TEST(StereoDepth, MindsThatPrincipalPointsDiffer) {
  StereoScene scene;
  scene.right.cx_px = 149.5;  // all disparities are 10 px larger
  const core::Frame frame = frameOf(scene);
  const cv::Mat middle = frame.depth_m.colRange(60, 260);
  EXPECT_GT(shareWithDepth(middle), 0.95);
  EXPECT_NEAR(cv::mean(middle, middle > 0)[0], 2.0, 0.02);
}

TEST(StereoDepth, EndsWithItsRange) {
  StereoOptions options;
  options.max_range_m = 1.5;
  EXPECT_LT(shareWithDepth(frameOf({}, options).depth_m), 0.001);
  options.max_range_m = 10.0;
  options.min_range_m = 2.5;
  EXPECT_LT(shareWithDepth(frameOf({}, options).depth_m), 0.01);
}

TEST(StereoDepth, FollowsCamerasThatChange) {
  StereoDepth stereo({});
  StereoScene scene;
  static_cast<void>(stereo.convert(*scene.record()));
  scene.T_left_right.translation().x() = 0.2;
  const core::Frame frame = FrameBuilder().build(stereo.convert(*scene.record()));
  EXPECT_NEAR(cv::mean(frame.depth_m, frame.depth_m > 0)[0], 2.0, 0.02);
  EXPECT_NEAR(stereo.noise().sigma_m(1.0), 0.25 / 50, 1e-9);
}

TEST(StereoDepth, RectifiesWhatIsNot) {
  StereoScene scene;
  scene.left.k1 = -0.2;
  scene.right.k1 = -0.15;
  scene.right.fx_px = scene.right.fy_px = 255.0;
  scene.T_left_right.translation() = Eigen::Vector3d(0.1, 0.004, -0.003);
  scene.T_left_right.rotate(Eigen::AngleAxisd(0.03, Eigen::Vector3d(1, -1, 1).normalized()));
  const core::Frame frame = frameOf(scene);
  EXPECT_FALSE(frame.camera.hasDistortion());
  EXPECT_GT(shareWithDepth(frame.depth_m.colRange(30, 300)), 0.9);
  std::vector<double> distances_m;
  for (int v = 20; v < 220; v += 10) {
    for (int u = 40; u < 300; u += 10) {
      const auto z_m = static_cast<double>(frame.depth_m.at<float>(v, u));
      if (z_m > 0) distances_m.push_back((frame.T_base_cam * frame.camera.unproject({u, v}, z_m)).z());
    }
  }
  const auto middle = distances_m.begin() + static_cast<std::ptrdiff_t>(distances_m.size() / 2);
  std::nth_element(distances_m.begin(), middle, distances_m.end());
  EXPECT_NEAR(*middle, 2.0, 0.04);  // a quarter of a pixel
  for (const double distance_m : distances_m) EXPECT_NEAR(distance_m, 2.0, 0.15);
}

TEST(StereoDepth, NeedsARightImage) {
  auto pair = StereoScene().record();
  pair->hasImageRight = false;
  expectError(*pair, "has no right image");
}

TEST(StereoDepth, NeedsImagesOfOneSize) {
  auto pair = StereoScene().record();
  pair->imageRight = mrpt::img::CImage(cv::Mat(120, 160, CV_8UC1, cv::Scalar(0)), mrpt::img::DEEP_COPY);
  expectError(*pair, "has a left image of 320x240 pixels and a right one of 160x120; record both in the same size");
}

TEST(StereoDepth, NeedsACalibrationOfBothCameras) {
  auto pair = StereoScene().record();
  pair->rightCamera.intrinsicParams.setZero();
  expectError(*pair, "no calibration of its right camera");
}

TEST(StereoDepth, NeedsACalibrationThatCanBeRectified) {
  StereoScene scene;
  for (core::CameraModel* camera : {&scene.left, &scene.right}) camera->k1 = 9000.0;
  auto pair = StereoScene().record();
  pair->leftCamera = core::toMrpt(scene.left);
  pair->rightCamera = core::toMrpt(scene.right);
  expectError(*pair, "cannot be rectified");
}

TEST(StereoDepth, NeedsABaseline) {
  auto pair = StereoScene().record();
  pair->rightCameraPose = {};
  expectError(*pair, "both cameras in one place");
}

TEST(StereoDepth, NeedsTheRightCameraOnTheRight) {
  for (const Eigen::Vector3d& wrong_m : {Eigen::Vector3d(-0.1, 0, 0), Eigen::Vector3d(0, 0.1, 0)}) {
    StereoScene scene;
    scene.T_left_right.translation() = wrong_m;
    expectError(*scene.record(), "does not stand to the right of the left one");
  }
}

TEST(StereoDepth, RefusesOptionsThatContradictEachOther) {
  StereoOptions even;
  even.block_size_px = 6;
  EXPECT_THAT([&] { StereoDepth stereo(even); },
              ThrowsMessage<core::InputError>(HasSubstr("sources.stereo.block_size")));
  StereoOptions empty;
  empty.min_range_m = empty.max_range_m;
  EXPECT_THAT([&] { StereoDepth stereo(empty); },
              ThrowsMessage<core::InputError>(HasSubstr("sources.stereo.min_range")));
}

}  // namespace
}  // namespace wardslam::sources
