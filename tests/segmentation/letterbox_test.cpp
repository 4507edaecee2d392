#include "wardslam/segmentation/letterbox.h"

#include <gtest/gtest.h>

namespace wardslam::segmentation {
namespace {

TEST(Letterbox, CentresAWideImage) {
  const Letterbox letterbox({640, 480}, {320, 256});
  EXPECT_EQ(letterbox.content_px(), cv::Rect(0, 8, 320, 240));
  EXPECT_DOUBLE_EQ(letterbox.scaleX(), 0.5);
  EXPECT_DOUBLE_EQ(letterbox.scaleY(), 0.5);
  EXPECT_EQ(letterbox.toImage({0, 8, 320, 240}), cv::Rect2d(0, 0, 640, 480));
  EXPECT_EQ(letterbox.toImage({10, 18, 100, 50}), cv::Rect2d(20, 20, 200, 100));
}

TEST(Letterbox, CentresATallImage) {
  const Letterbox letterbox({100, 200}, {100, 100});
  EXPECT_EQ(letterbox.content_px(), cv::Rect(25, 0, 50, 100));
  EXPECT_EQ(letterbox.toImage({25, 0, 50, 100}), cv::Rect2d(0, 0, 100, 200));
}

TEST(Letterbox, EnlargesASmallImage) { EXPECT_EQ(Letterbox({10, 5}, {40, 40}).content_px(), cv::Rect(0, 10, 40, 20)); }

TEST(Letterbox, InvertsItsRoundingExactly) {
  const Letterbox letterbox({641, 479}, {320, 256});
  const cv::Rect2d content = letterbox.content_px();
  EXPECT_NEAR(letterbox.toImage(content).width, 641.0, 1e-9);
  EXPECT_NEAR(letterbox.toImage(content).height, 479.0, 1e-9);
}

TEST(Letterbox, FillsTheRestWithGrey114) {
  const cv::Mat white(20, 40, CV_8UC3, cv::Scalar::all(255));
  const Letterbox letterbox(white.size(), {20, 20});
  const cv::Mat input = letterbox.apply(white);
  ASSERT_EQ(input.size(), cv::Size(20, 20));
  for (int y = 0; y < 20; ++y) {
    const int expected = letterbox.content_px().contains({0, y}) ? 255 : 114;
    EXPECT_EQ(input.at<cv::Vec3b>(y, 10), cv::Vec3b::all(static_cast<uchar>(expected))) << y;
  }
}

}  // namespace
}  // namespace wardslam::segmentation
