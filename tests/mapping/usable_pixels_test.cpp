#include "usable_pixels.h"

#include <gtest/gtest.h>

namespace wardslam::mapping {
namespace {

constexpr core::ClassId kPerson = 1;

/// 20 × 20 pixels of a wall at 2 m.
View view() {
  View view;
  view.depth_m = cv::Mat(20, 20, CV_32FC1, cv::Scalar(2.0));
  return view;
}

knowledge::ClassSet moving() {
  knowledge::ClassSet classes;
  classes.set(kPerson);
  return classes;
}

CloudOptions options(int margin_px) {
  CloudOptions options;
  options.mover_margin_px = margin_px;
  options.max_range_m = 4.0;
  return options;
}

TEST(UsablePixelsTest, ASmoothSurfaceIsUsable) {
  EXPECT_EQ(cv::countNonZero(usablePixels(view(), moving(), options(2))), 400);
}

TEST(UsablePixelsTest, HolesAndFarPixelsAreNot) {
  View v = view();
  v.depth_m.at<float>(3, 4) = 0.0F;
  v.depth_m.row(19).setTo(4.5F);
  const cv::Mat usable = usablePixels(v, moving(), options(2));
  EXPECT_EQ(cv::countNonZero(usable), 400 - 1 - 20);
  EXPECT_EQ(usable.at<std::uint8_t>(3, 4), 0);
}

TEST(UsablePixelsTest, MoversAndAMarginRoundThemAreNot) {
  View v = view();
  v.segmentation.classIds = cv::Mat(20, 20, CV_8UC1, cv::Scalar(0));
  v.segmentation.classIds.at<std::uint8_t>(10, 10) = kPerson;
  v.segmentation.classIds.at<std::uint8_t>(2, 2) = 57;
  v.mayMove = cv::Mat(20, 20, CV_8UC1, cv::Scalar(0));
  v.mayMove.at<std::uint8_t>(18, 18) = 1;
  const cv::Mat usable = usablePixels(v, moving(), options(2));
  EXPECT_EQ(cv::countNonZero(usable), 400 - 25 - 16);  // the second square is cut by the border
  EXPECT_EQ(usable.at<std::uint8_t>(8, 12), 0);
  EXPECT_NE(usable.at<std::uint8_t>(7, 12), 0);
  EXPECT_NE(usable.at<std::uint8_t>(2, 2), 0);
  EXPECT_EQ(v.mayMove.at<std::uint8_t>(17, 17), 0);  // the view itself is left as it was
}

TEST(UsablePixelsTest, FliersHangBetweenNearAndFar) {
  View v = view();
  v.depth_m.colRange(10, 20).setTo(3.0F);  // an edge: both sides stay
  EXPECT_EQ(cv::countNonZero(usablePixels(v, moving(), options(0))), 400);
  v.depth_m.col(10).setTo(2.5F);  // mixed pixels on it
  const cv::Mat usable = usablePixels(v, moving(), options(0));
  EXPECT_EQ(cv::countNonZero(usable), 380);
  EXPECT_EQ(cv::countNonZero(usable.col(10)), 0);
}

TEST(UsablePixelsTest, AStepIsLargerTheFartherAway) {
  EXPECT_NEAR(edgeStep_m(1.0F), 0.02 + 3 * (0.0012 + 0.0019 * 0.36) + 1.0 / 348, 1e-6);
  EXPECT_GT(edgeStep_m(4.0F), 2 * edgeStep_m(2.0F));
}

}  // namespace
}  // namespace wardslam::mapping
