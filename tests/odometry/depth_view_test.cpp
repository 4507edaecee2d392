#include "wardslam/odometry/depth_view.h"

#include <gtest/gtest.h>

namespace wardslam::odometry {
namespace {

/// A wall across the whole image, seen by the default camera of 640 x 480.
DepthImage wallAt(float depth_m) { return {cv::Mat(480, 640, CV_32FC1, cv::Scalar(depth_m)), {}}; }

Eigen::Isometry3d ahead(double z_m) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation().z() = z_m;
  return T;
}

const core::CameraModel kCamera;

TEST(DepthView, KeepsNearestAndFarthestOfEachCell) {
  DepthImage image = wallAt(3.0F);
  image.depth_m.at<float>(13, 25) = 1.5F;                    // cell (2, 1)
  image.depth_m(cv::Rect(0, 0, 10, 10)) = cv::Scalar(0.0F);  // cell (0, 0)
  const DepthView view = makeDepthView(image);
  ASSERT_EQ(view.cell_px, 10);
  ASSERT_EQ(view.columns, 64);
  ASSERT_EQ(view.rows, 48);
  EXPECT_EQ(view.nearest_mm[1 * 64 + 2], 1500);
  EXPECT_EQ(view.farthest_mm[1 * 64 + 2], 3000);
  EXPECT_EQ(view.nearest_mm[0], 0);
}

TEST(DepthView, SaysWhatBecomesOfASurfaceThatShouldBeThere) {
  const DepthView view = makeDepthView(wallAt(3.0F));
  EXPECT_EQ(lookUp(view, kCamera, {0.2, 0.1, 3.05}), InDepth::Agrees);
  EXPECT_EQ(lookUp(view, kCamera, {0.2, 0.1, 2.0}), InDepth::SeenThrough);
  EXPECT_EQ(lookUp(view, kCamera, {0.2, 0.1, 4.0}), InDepth::Hidden);
  EXPECT_EQ(lookUp(view, kCamera, {9.0, 0.1, 3.0}), InDepth::Unknown) << "beside the image";
  EXPECT_EQ(lookUp(view, kCamera, {0.0, 0.0, -3.0}), InDepth::Unknown) << "behind the camera";
  EXPECT_EQ(lookUp({}, kCamera, {0.0, 0.0, 3.0}), InDepth::Unknown) << "without depth";
}

TEST(DepthView, MayShowWhatNothingHides) {
  DepthImage image = wallAt(3.0F);
  image.depth_m(cv::Rect(400, 0, 100, 480)).setTo(1.0F);  // somebody stands there
  image.depth_m(cv::Rect(550, 0, 50, 480)).setTo(0.0F);
  image.mayMove = cv::Mat(480, 640, CV_8UC1, cv::Scalar(0));
  image.mayMove(cv::Rect(100, 200, 60, 60)) = cv::Scalar(255);
  const core::DepthNoise noise;
  EXPECT_TRUE(maySee(image, {300, 240}, 3.0, noise));
  EXPECT_TRUE(maySee(image, {300, 240}, 2.0, noise)) << "what is not there any more is not hidden";
  EXPECT_FALSE(maySee(image, {450, 240}, 3.0, noise)) << "behind somebody";
  EXPECT_TRUE(maySee(image, {400, 240}, 3.0, noise)) << "where he ends nobody knows to the pixel";
  EXPECT_FALSE(maySee(image, {130, 230}, 3.0, noise)) << "something moves there";
  EXPECT_TRUE(maySee(image, {575, 240}, 3.0, noise)) << "nothing was measured";
  EXPECT_TRUE(maySee({}, {575, 240}, 3.0, noise)) << "nor here";
}

TEST(DepthView, SaysNothingOfWhatMayMove) {
  DepthImage image = wallAt(3.0F);
  image.mayMove = cv::Mat(480, 640, CV_8UC1, cv::Scalar(0));
  image.mayMove(cv::Rect(300, 200, 60, 60)) = cv::Scalar(255);
  const DepthView view = makeDepthView(image);
  EXPECT_EQ(lookUp(view, kCamera, {0.0, 0.0, 1.0}), InDepth::Unknown);
  EXPECT_EQ(lookUp(view, kCamera, {-1.0, 0.0, 2.0}), InDepth::SeenThrough);
}

TEST(DepthView, ComparesTwoLooksAtOnePlace) {
  const DepthView near = makeDepthView(wallAt(2.0F));
  const DepthView far = makeDepthView(wallAt(3.0F));
  const auto same = compareDepth(near, kCamera, far, kCamera, ahead(-1.0));  // the other stands a metre back
  EXPECT_GT(same.agreeing, 1000);
  EXPECT_EQ(same.seenThrough, 0);
  EXPECT_EQ(same.hidden, 0);
  EXPECT_NEAR(same.overlap(), 4.0 / 9.0, 0.05) << "of what it saw from farther away";
  EXPECT_EQ(same.contradiction(), 0.0);

  const auto other = compareDepth(far, kCamera, near, kCamera, Eigen::Isometry3d::Identity());
  EXPECT_EQ(other.contradiction(), 1.0) << "there is nothing at two metres";
  const auto behind = compareDepth(near, kCamera, far, kCamera, Eigen::Isometry3d::Identity());
  EXPECT_GT(behind.hidden, 1000);
  EXPECT_EQ(behind.contradiction(), 0.0) << "what is behind something may be there";
}

}  // namespace
}  // namespace wardslam::odometry
