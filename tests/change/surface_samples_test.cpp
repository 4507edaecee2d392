#include "wardslam/change/surface_samples.h"

#include <gtest/gtest.h>

#include "change/depth_scene.h"

namespace wardslam::change {
namespace {

const auto kAll = [](int, int) { return true; };

TEST(SurfaceSamples, ArePointsOfTheSurface) {
  test::DepthScene scene;
  scene.add({1, 57, {0.2, -0.1, 2.0}, 0.6, 0.4});
  const core::Frame frame = scene.frame(0.0);
  const auto& chair = frame.segmentation.instances[0];
  const auto points = sampleSurface(frame, chair.box_px, 100, kAll);
  EXPECT_GT(points.size(), 50U);
  EXPECT_LE(points.size(), 110U);
  for (const auto& p : points) {
    EXPECT_NEAR(p.z(), 2.0, 1e-6);
    EXPECT_NEAR(p.x(), 0.2, 0.31);
    EXPECT_NEAR(p.y(), -0.1, 0.21);
  }
}

TEST(SurfaceSamples, AreOnlyWhereAskedForAndWhereThereIsDepth) {
  core::Frame frame = test::DepthScene().frame(0.0);
  const auto isLeft = [](int, int column) { return column < 160; };
  for (const auto& p : sampleSurface(frame, {0, 0, 320, 240}, 1000, isLeft)) EXPECT_LT(p.x(), 0.0);
  frame.depth_m.setTo(0.0);
  EXPECT_TRUE(sampleSurface(frame, {0, 0, 320, 240}, 1000, kAll).empty());
  EXPECT_TRUE(sampleSurface(frame, {400, 0, 10, 10}, 1000, kAll).empty()) << "outside the image";
}

TEST(SurfaceSamples, AllowForTheLens) {
  core::Frame frame = test::DepthScene().frame(0.0);
  frame.camera.k1 = -0.2;
  double error_px = 0.0;
  const cv::Rect pixel(300, 20, 1, 1);
  for (const auto& p : sampleSurface(frame, pixel, 1, kAll)) {
    error_px = (frame.camera.projectDistorted(p) - Eigen::Vector2d(300, 20)).norm();
    EXPECT_GT((frame.camera.project(p) - Eigen::Vector2d(300, 20)).norm(), 3.0);
  }
  EXPECT_LT(error_px, 0.1);
}

TEST(SurfaceSamples, TheGapIsTheSmallestDistance) {
  EXPECT_DOUBLE_EQ(gapBetween({{0, 0, 1}, {1, 0, 1}}, {{5, 0, 1}, {1, 3, 5}}), 4.0);
  EXPECT_TRUE(std::isinf(gapBetween({}, {{0, 0, 1}})));
}

}  // namespace
}  // namespace wardslam::change
