#include "depth_surfaces.h"

#include <gtest/gtest.h>

namespace wardslam::masks {
namespace {

const cv::Mat kOnePart(30, 40, CV_8UC1, cv::Scalar(0));

cv::Mat depthOf(double depth_m) { return {30, 40, CV_32FC1, cv::Scalar(depth_m)}; }

Surfaces surfacesOf(const cv::Mat& depth_m, const cv::Mat& parts = kOnePart) {
  return findSurfaces(inverseDepth(depth_m), parts, {});
}

TEST(InverseDepth, IsZeroWhereNothingWasMeasured) {
  cv::Mat depth_m = depthOf(4.0);
  depth_m.at<float>(3, 5) = 0.0F;
  const cv::Mat inverse = inverseDepth(depth_m);
  EXPECT_EQ(inverse.at<float>(0, 0), 0.25F);
  EXPECT_EQ(inverse.at<float>(3, 5), 0.0F);
}

TEST(IsContinuous, AllowsForRoughnessNearAndNoiseFar) {
  const auto joined = [](double a_m, double b_m, const core::DepthNoise& noise = {}) {
    return isContinuous(static_cast<float>(1 / a_m), static_cast<float>(1 / b_m), noise);
  };
  // 0.03 m + 0.0057 z²: 3.6 cm at 1 m, 12 cm at 4 m.
  EXPECT_TRUE(joined(1.0, 1.03));
  EXPECT_FALSE(joined(1.0, 1.04));
  EXPECT_TRUE(joined(4.0, 4.11));
  EXPECT_FALSE(joined(4.0, 4.14));
  EXPECT_FALSE(isContinuous(0.0F, 0.0F, {})) << "not measured";
  // A pair of cameras 10 cm apart with a focal length of 500 px and disparities good to half a pixel: 0.03 m + 0.03 z².
  const core::DepthNoise stereo{0.0, 0.01, 0.0};
  EXPECT_TRUE(joined(4.0, 4.4, stereo));
  EXPECT_FALSE(joined(4.0, 4.7, stereo));
}

TEST(FindSurfaces, CutsWhereDepthJumps) {
  cv::Mat depth_m = depthOf(3.0);
  depth_m(cv::Rect(10, 5, 8, 20)).setTo(2.0);
  const Surfaces surfaces = surfacesOf(depth_m);
  EXPECT_EQ(surfaces.count, 3) << "not measured, wall, thing";
  EXPECT_EQ(surfaces.labels.at<int>(0, 0), surfaces.labels.at<int>(29, 39)) << "the wall goes round the thing";
  EXPECT_NE(surfaces.labels.at<int>(0, 0), surfaces.labels.at<int>(10, 12));
}

TEST(FindSurfaces, FollowsASlope) {
  cv::Mat depth_m(30, 40, CV_32FC1);
  for (int y = 0; y < 30; ++y) depth_m.row(y).setTo(1.0 + 0.03 * y);
  EXPECT_EQ(surfacesOf(depth_m).count, 2);
}

TEST(FindSurfaces, JoinsBranchesThatMeetBelow) {
  cv::Mat depth_m = depthOf(0.0);
  for (const int x : {5, 15, 25}) depth_m(cv::Rect(x, 5, 3, 20)).setTo(2.0);
  EXPECT_EQ(surfacesOf(depth_m).count, 4);
  depth_m(cv::Rect(5, 24, 23, 2)).setTo(2.0);
  const Surfaces comb = surfacesOf(depth_m);
  EXPECT_EQ(comb.count, 2);
  EXPECT_EQ(comb.labels.at<int>(6, 6), comb.labels.at<int>(6, 26));
  EXPECT_EQ(comb.labels.at<int>(0, 0), 0);
}

TEST(FindSurfaces, EndsThemWithTheirPart) {
  cv::Mat parts = kOnePart.clone();
  parts.rowRange(20, 30).setTo(255);
  const Surfaces surfaces = surfacesOf(depthOf(2.0), parts);
  EXPECT_EQ(surfaces.count, 3);
  EXPECT_NE(surfaces.labels.at<int>(19, 0), surfaces.labels.at<int>(20, 0));
}

}  // namespace
}  // namespace wardslam::masks
