#include "wardslam/sources/frame_builder.h"

#include <gmock/gmock.h>

#include <limits>

#include "sources/scan_maker.h"
#include "wardslam/core/errors.h"

namespace wardslam::sources {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(FrameBuilder, TakesStampCameraAndImages) {
  const auto scan = test::makeScan(2);
  FrameBuilder builder;
  const core::Frame frame = builder.build(scan);
  EXPECT_EQ(frame.index, 0U);
  EXPECT_NEAR(frame.stamp_s, 1002.0, 1e-6);
  EXPECT_EQ(frame.camera.width_px, 8);
  EXPECT_EQ(frame.camera.cx_px, 3.5);
  EXPECT_EQ(frame.observation, scan);
  EXPECT_EQ(cv::norm(frame.color_bgr, scan->intensityImage.asCvMatRef(), cv::NORM_INF), 0.0);

  ASSERT_EQ(frame.gray.type(), CV_8UC1);
  const auto bgr = frame.color_bgr.at<cv::Vec3b>(4, 5);
  EXPECT_NEAR(frame.gray.at<std::uint8_t>(4, 5), 0.114 * bgr[0] + 0.587 * bgr[1] + 0.299 * bgr[2], 1.0);

  ASSERT_EQ(frame.depth_m.type(), CV_32FC1);
  EXPECT_NEAR(frame.depth_m.at<float>(3, 5), 1.031, 1e-6);  // 1000 + 3 * 8 + 5 + 2 mm
}

TEST(FrameBuilder, SaysHowSureDepthIsAndHowLongAnImageIsReadFor) {
  FrameBuilder builder;
  EXPECT_EQ(builder.build(test::makeScan()).camera.depthNoise, core::DepthNoise());
  const core::DepthNoise stereo{0.0, 0.004, 0.0};
  builder.setSensorTraits({stereo, 0.02});
  EXPECT_EQ(builder.build(test::makeScan()).camera.depthNoise, stereo);
  EXPECT_EQ(builder.build(test::makeScan()).camera.readout_s, 0.02);
}

TEST(FrameBuilder, NumbersFrames) {
  FrameBuilder builder;
  EXPECT_EQ(builder.build(test::makeScan()).index, 0U);
  EXPECT_EQ(builder.build(test::makeScan()).index, 1U);
}

TEST(FrameBuilder, AnImageOfAnotherSizeIsRefusedAndTakesNoNumber) {
  FrameBuilder builder;
  (void)builder.build(test::makeScan());
  const auto smaller = test::makeScan();
  smaller->intensityImage = mrpt::img::CImage(cv::Mat(3, 4, CV_8UC1, cv::Scalar(77)), mrpt::img::DEEP_COPY);
  smaller->rangeImage_setSize(3, 4);
  smaller->cameraParams.nrows = smaller->cameraParamsIntensity.nrows = 3;
  smaller->cameraParams.ncols = smaller->cameraParamsIntensity.ncols = 4;
  EXPECT_THAT([&] { (void)builder.build(smaller); },
              ThrowsMessage<core::FrameError>(HasSubstr("the image has 4x3 pixels, those before it 8x6")));
  EXPECT_EQ(builder.build(test::makeScan()).index, 1U);
  EXPECT_EQ(FrameBuilder().build(smaller).index, 0U) << "nothing is wrong with it by itself";
}

TEST(FrameBuilder, TakesMonochromeImages) {
  const auto scan = test::makeScan();
  cv::Mat gray(6, 8, CV_8UC1, cv::Scalar(77));
  scan->intensityImage = mrpt::img::CImage(gray, mrpt::img::DEEP_COPY);
  const core::Frame frame = FrameBuilder().build(scan);
  EXPECT_EQ(frame.gray.at<std::uint8_t>(1, 1), 77);
  ASSERT_EQ(frame.color_bgr.type(), CV_8UC3);
  EXPECT_EQ(frame.color_bgr.at<cv::Vec3b>(1, 1), cv::Vec3b(77, 77, 77));
}

TEST(FrameBuilder, NoReturnAndAbsurdDepthAreNoDepth) {
  const auto scan = test::makeScan();
  scan->rangeImage(0, 0) = 0;
  scan->rangeImage(0, 1) = 65535;  // 65.5 m: "out of range" of some sensors
  const core::Frame frame = FrameBuilder().build(scan);
  EXPECT_EQ(frame.depth_m.at<float>(0, 0), 0.0F);
  EXPECT_EQ(frame.depth_m.at<float>(0, 1), 0.0F);
  EXPECT_GT(frame.depth_m.at<float>(0, 2), 0.0F);
}

TEST(FrameBuilder, TurnsRangeAlongTheRayIntoDepth) {
  const auto scan = test::makeScan();
  scan->range_is_depth = false;
  const core::Frame frame = FrameBuilder().build(scan);
  // Pixel (7, 5): ray (3.5 / 8, 2.5 / 8, 1), length 1.135369; range 1.047 m.
  EXPECT_NEAR(frame.depth_m.at<float>(5, 7), 1.047 / 1.135369, 1e-5);
}

TEST(FrameBuilder, RegistersDepthOfASecondCamera) {
  const auto scan = test::makeScan();
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 8; ++column) scan->rangeImage(row, column) = column < 2 ? 0 : 1000;
  }
  // The colour camera is 0.25 m to the left of the depth camera (y is left in MRPT's sensor frame): points appear
  // f b / z = 8 * 0.25 / 1 = 2 px further right in its image.
  scan->relativePoseIntensityWRTDepth.y(0.25);
  const core::Frame frame = FrameBuilder().build(scan);
  for (int column = 0; column < 8; ++column) {
    EXPECT_NEAR(frame.depth_m.at<float>(3, column), column < 4 ? 0.0 : 1.0, 1e-6) << column;
  }
}

TEST(FrameBuilder, RegistersDepthOfAnotherSize) {
  const auto scan = test::makeScan();
  core::CameraModel half = core::fromMrpt(scan->cameraParams);
  half.width_px = 4;
  half.height_px = 3;
  half.fx_px = half.fy_px = 4.0;
  half.cx_px = 1.5;
  half.cy_px = 1.0;
  scan->cameraParams = core::toMrpt(half);
  scan->rangeImage_setSize(3, 4);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) scan->rangeImage(row, column) = 2000;
  }
  const core::Frame frame = FrameBuilder().build(scan);
  EXPECT_EQ(frame.depth_m.size(), cv::Size(8, 6));
  double least_m = 0.0;
  double most_m = 0.0;
  cv::minMaxLoc(frame.depth_m, &least_m, &most_m);
  EXPECT_NEAR(least_m, 2.0, 1e-6);  // no pinholes
  EXPECT_NEAR(most_m, 2.0, 1e-6);
}

TEST(FrameBuilder, FollowsACameraThatChanges) {
  FrameBuilder builder;
  const auto first = test::makeScan();
  first->range_is_depth = false;
  const auto second = test::makeScan();
  second->range_is_depth = false;
  core::CameraModel other = core::fromMrpt(second->cameraParams);
  other.fx_px = other.fy_px = 4.0;
  second->cameraParams = second->cameraParamsIntensity = core::toMrpt(other);
  EXPECT_NEAR(builder.build(first).depth_m.at<float>(5, 7), 1.047 / 1.135369, 1e-5);
  EXPECT_NEAR(builder.build(second).depth_m.at<float>(5, 7), 1.047 / std::sqrt(1 + 0.765625 + 0.390625), 1e-5);
}

class UnusableScan : public ::testing::Test {
 protected:
  void expectError(const std::string& what) const {
    EXPECT_THAT([&] { return FrameBuilder().build(scan); }, ThrowsMessage<core::FrameError>(HasSubstr(what)));
  }
  std::shared_ptr<mrpt::obs::CObservation3DRangeScan> scan = test::makeScan();
};

TEST_F(UnusableScan, WithoutIntensityImage) {
  scan->hasIntensityImage = false;
  expectError("has no intensity image");
}

TEST_F(UnusableScan, WithoutRangeImage) {
  scan->hasRangeImage = false;
  expectError("has no range image");
}

TEST_F(UnusableScan, WithoutStamp) {
  scan->timestamp = INVALID_TIMESTAMP;
  expectError("has no time stamp");
}

TEST_F(UnusableScan, WithoutRangeUnit) {
  scan->rangeUnits = 0.0F;
  expectError("has no valid range unit");
}

TEST_F(UnusableScan, WithoutCalibration) {
  scan->cameraParamsIntensity.intrinsicParams.setZero();
  expectError("has no calibration of its colour camera");
}

TEST_F(UnusableScan, WithACalibrationThatNoCameraHas) {
  const auto sound = scan->cameraParams;
  for (const double focus_px : {1e-30, 1e30}) {
    scan->cameraParams.fx(focus_px);
    expectError("has a calibration of its depth camera that no camera has");
  }
  for (const double k : {1e300, std::numeric_limits<double>::quiet_NaN()}) {
    scan->cameraParams = sound;
    scan->cameraParams.dist[1] = k;
    expectError("has a calibration of its depth camera that no camera has");
  }
}

TEST_F(UnusableScan, WithAPoseThatIsNone) {
  scan->sensorPose.x(std::numeric_limits<double>::quiet_NaN());
  expectError("has a pose of its camera that is none");
  scan->sensorPose = {};
  scan->relativePoseIntensityWRTDepth.z(1e300);
  expectError("has a pose of its camera that is none");
}

TEST_F(UnusableScan, WithAnImageThatIsNotOfItsCamerasSize) {
  scan->cameraParamsIntensity.ncols = 16;
  expectError("colour image of 8x6 pixels, but its camera has 16x6");
}

TEST_F(UnusableScan, WithARangeImageThatIsNotOfItsCamerasSize) {
  scan->cameraParams.nrows = 12;
  expectError("depth image of 8x6 pixels, but its camera has 8x12");
}

TEST_F(UnusableScan, WithAFisheye) {
  scan->cameraParams.distortion = mrpt::img::DistortionModel::kannala_brandt;
  expectError("fisheye");
}

TEST_F(UnusableScan, WithASixteenBitImage) {
  scan->intensityImage = mrpt::img::CImage(cv::Mat(6, 8, CV_16UC1, cv::Scalar(0)), mrpt::img::DEEP_COPY);
  expectError("not 8 bit");
}

}  // namespace
}  // namespace wardslam::sources
