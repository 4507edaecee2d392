#include "still_images.h"

#include <gtest/gtest.h>

namespace wardslam::sources {
namespace {

class StillImagesTest : public ::testing::Test {
 protected:
  /// Colour and depth are told by a number each.
  core::Frame look(double stamp_s, int color, float depth_m) {
    core::Frame frame;
    frame.stamp_s = stamp_s;
    frame.gray = cv::Mat(6, 8, CV_8UC1, cv::Scalar(10));
    frame.gray.at<std::uint8_t>(5, 7) = static_cast<std::uint8_t>(color);
    frame.depth_m = cv::Mat(6, 8, CV_32FC1, cv::Scalar(2.0));
    frame.depth_m.at<float>(5, 7) = depth_m;
    if (depth_m == 0.0F) frame.depth_m.setTo(0.0F);
    still_.look(frame);
    return frame;
  }

  StillImages still_;
};

TEST_F(StillImagesTest, WhatChangesInOnePixelIsNotStill) {
  for (int i = 0; i < 20; ++i) {
    const auto frame = look(0.1 * i, i, 1.0F + static_cast<float>(i));
    EXPECT_TRUE(frame.events.empty()) << i;
    EXPECT_GT(cv::countNonZero(frame.depth_m), 0) << i;
  }
}

TEST_F(StillImagesTest, DepthThatStandsStillWhileColoursGoOnIsNone) {
  for (int i = 0; i < 6; ++i) {
    const auto frame = look(0.1 * i, i, 1.0F);
    const bool isStill = i > 1;  // once may be late
    EXPECT_EQ(frame.events.count("sources.depth_still"), isStill ? 1U : 0U) << i;
    EXPECT_EQ(cv::countNonZero(frame.depth_m), isStill ? 0 : 48) << i;
    EXPECT_EQ(frame.depth_m.size(), frame.gray.size());
  }
  EXPECT_TRUE(look(0.6, 6, 1.5F).events.empty()) << "it goes on";
  (void)look(0.7, 7, 1.5F);
  EXPECT_EQ(look(0.8, 8, 1.5F).events.count("sources.depth_still"), 1U) << "what stood still taught nothing";
}

TEST_F(StillImagesTest, DepthOfALowerRateIsKnownByItsRepeats) {
  for (int i = 0; i < 30; ++i) {  // 30 and 5 images a second
    const auto frame = look(i / 30.0, i, 1.0F + static_cast<float>(i / 6));
    EXPECT_EQ(frame.events.count("sources.depth_still"), i >= 2 && i < 6 ? 1U : 0U) << i;
  }
}

TEST_F(StillImagesTest, AFrozenCameraRepeatsItsImages) {
  (void)look(0.0, 1, 1.0F);
  for (int i = 1; i < 9; ++i) {
    const auto frame = look(0.1 * i, 1, 1.0F);
    EXPECT_EQ(frame.events, (core::EventCounts{{"sources.image_repeated", 1}}));
    EXPECT_EQ(cv::countNonZero(frame.depth_m), 48) << "it may just rest, where nothing is measured";
  }
}

TEST_F(StillImagesTest, WithoutAnyDepthNothingStandsStill) {
  for (int i = 0; i < 9; ++i) EXPECT_TRUE(look(0.1 * i, i, 0.0F).events.empty()) << i;
}

}  // namespace
}  // namespace wardslam::sources
