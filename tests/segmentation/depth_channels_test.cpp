#include "wardslam/segmentation/depth_channels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "segmentation/fake_network.h"
#include "wardslam/core/options.h"

namespace wardslam::segmentation {
namespace {

namespace fs = std::filesystem;
using test::blobAt;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

core::CameraModel camera(int width_px, int height_px, double f_px = 500.0) {
  core::CameraModel camera;
  camera.width_px = width_px;
  camera.height_px = height_px;
  camera.fx_px = camera.fy_px = f_px;
  camera.cx_px = 0.5 * width_px - 0.5;
  camera.cy_px = 0.5 * height_px - 0.5;
  return camera;
}

/// A plane with this normal (of length 1) that the optical axis meets at 2 m.
DepthPicture plane(double nx, double ny, double nz) {
  DepthPicture picture{cv::Mat(48, 64, CV_32FC1), 50.0, 60.0, 31.5, 23.5};
  for (int v = 0; v < 48; ++v) {
    for (int u = 0; u < 64; ++u) {
      const double x = (u - picture.cx_px) / picture.fx_px;
      const double y = (v - picture.cy_px) / picture.fy_px;
      picture.depth_m.at<float>(v, u) = static_cast<float>(2.0 * nz / (nx * x + ny * y + nz));
    }
  }
  return picture;
}

/// Made by training/export_vectors.py.
TEST(DepthChannels, AreThoseTheNetworkWasTrainedWith) {
  const fs::path folder = WARDSLAM_DEPTH_CHANNELS_DIR;
  const auto description = core::ConfigNode::fromFile(folder / "camera.json").yaml();
  core::CameraModel camera;
  camera.fx_px = description["fx"].as<double>();
  camera.fy_px = description["fy"].as<double>();
  camera.cx_px = description["cx"].as<double>();
  camera.cy_px = description["cy"].as<double>();
  const cv::Mat raw = cv::imread((folder / "depth.png").string(), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(raw.size(), cv::Size(176, 132));
  cv::Mat depth_m;
  raw.convertTo(depth_m, CV_32F, 1.0 / 5000.0);

  const cv::Mat channels = depthChannels(fitDepth(depth_m, camera, Letterbox(raw.size(), {88, 66})));
  cv::Mat reference({1, kDepthChannels, 66, 88}, CV_32F);
  std::ifstream in(folder / "channels.f32", std::ios::binary);
  in.read(reinterpret_cast<char*>(reference.data), static_cast<std::streamsize>(reference.total() * sizeof(float)));
  ASSERT_TRUE(in);
  EXPECT_LT(cv::norm(channels, reference, cv::NORM_INF), 1e-5);
}

TEST(DepthChannels, TellTheNormalOfAPlaneWhateverItsPlaceInTheImage) {
  for (const auto& [nx, ny, nz] : {std::tuple(0.0, 0.0, 1.0), {0.6, 0.0, 0.8}, {0.0, -0.6, 0.8}, {0.48, 0.36, 0.8}}) {
    const DepthPicture picture = plane(nx, ny, nz);
    const cv::Mat channels = depthChannels(picture);
    for (const cv::Point p : {cv::Point(31, 23), cv::Point(2, 2), cv::Point(61, 45)}) {
      const float z_m = picture.depth_m.at<float>(p);
      EXPECT_FLOAT_EQ(blobAt(channels, 0, p.y, p.x), 1.0F / z_m);
      EXPECT_FLOAT_EQ(blobAt(channels, 1, p.y, p.x), 1.0F);
      EXPECT_NEAR(blobAt(channels, 2, p.y, p.x), nx, 1e-4);
      EXPECT_NEAR(blobAt(channels, 3, p.y, p.x), ny, 1e-4);
      EXPECT_NEAR(blobAt(channels, 4, p.y, p.x), (p.x - 31.5) / 50.0 * static_cast<double>(z_m) / 3.0, 1e-5);
      EXPECT_NEAR(blobAt(channels, 5, p.y, p.x), (p.y - 23.5) / 60.0 * static_cast<double>(z_m) / 3.0, 1e-5);
    }
  }
}

TEST(DepthChannels, AreZeroWhereNothingWasMeasured) {
  DepthPicture picture = plane(0.6, 0.0, 0.8);
  picture.depth_m(cv::Rect(20, 10, 12, 12)).setTo(0.0F);
  picture.depth_m.at<float>(15, 25) = 1.0F;
  const cv::Mat channels = depthChannels(picture);
  for (int c = 0; c < kDepthChannels; ++c) EXPECT_EQ(blobAt(channels, c, 12, 22), 0.0F) << c;
  EXPECT_EQ(blobAt(channels, 0, 15, 25), 1.0F);
  EXPECT_EQ(blobAt(channels, 2, 15, 25), 0.0F) << "alone, it has no slope";
  EXPECT_EQ(cv::norm(depthChannels({cv::Mat::zeros(4, 6, CV_32F), 5.0, 5.0, 2.5, 1.5}), cv::NORM_INF), 0.0);
}

TEST(DepthChannels, PlacesFarToTheSideAreCut) {
  const DepthPicture picture{cv::Mat(6, 6, CV_32F, cv::Scalar(9.0)), 3.0, 3.0, 2.5, 2.5};  // 7.5 m to the side
  const cv::Mat channels = depthChannels(picture);
  EXPECT_EQ(blobAt(channels, 4, 0, 0), -1.5F);
  EXPECT_EQ(blobAt(channels, 5, 5, 0), 1.5F);
}

TEST(FitDepth, TakesTheNearestThatWasMeasured) {
  cv::Mat depth_m(480, 640, CV_32F, cv::Scalar(3.0));
  depth_m.at<float>(0, 0) = 0.0F;
  depth_m.at<float>(0, 1) = kNaN;
  depth_m.at<float>(1, 0) = -1.0F;
  depth_m.at<float>(101, 201) = 1.5F;
  depth_m(cv::Rect(638, 478, 2, 2)).setTo(kNaN);
  const DepthPicture picture = fitDepth(depth_m, camera(640, 480), Letterbox({640, 480}, {320, 240}));
  ASSERT_EQ(picture.depth_m.size(), cv::Size(320, 240));
  EXPECT_EQ(picture.depth_m.at<float>(0, 0), 3.0F);
  EXPECT_EQ(picture.depth_m.at<float>(50, 100), 1.5F);
  EXPECT_EQ(picture.depth_m.at<float>(239, 319), 0.0F);
  EXPECT_DOUBLE_EQ(picture.fx_px, 250.0);
  EXPECT_DOUBLE_EQ(picture.cx_px, 159.5);
  EXPECT_DOUBLE_EQ(picture.cy_px, 119.5);
}

/// A pixel's ray stays the same, whatever the shape of the image.
TEST(FitDepth, KeepsRays) {
  for (const cv::Size size : {cv::Size(1280, 720), cv::Size(848, 480), cv::Size(320, 240), cv::Size(160, 120)}) {
    const core::CameraModel big = camera(size.width, size.height);
    const Letterbox letterbox(size, {320, 240});
    cv::Mat depth_m(size, CV_32F, cv::Scalar(2.0));
    const DepthPicture picture = fitDepth(depth_m, big, letterbox);
    EXPECT_EQ(cv::countNonZero(picture.depth_m), letterbox.content_px().area()) << size;
    EXPECT_NEAR((-0.5 + letterbox.content_px().x - picture.cx_px) / picture.fx_px, (-0.5 - big.cx_px) / big.fx_px, 1e-9)
        << size << ": the left edge";
    EXPECT_NEAR((-0.5 + letterbox.content_px().y - picture.cy_px) / picture.fy_px, (-0.5 - big.cy_px) / big.fy_px, 1e-9)
        << size << ": the upper edge";
  }
}

}  // namespace
}  // namespace wardslam::segmentation
