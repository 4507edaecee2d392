#include "wardslam/evaluation/detection_score.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wardslam::evaluation {
namespace {

TEST(DetectionScore, CountsPixels) {
  const cv::Mat detected = (cv::Mat_<uchar>(2, 4) << 1, 255, 0, 0, 7, 0, 0, 0);
  const cv::Mat truth = (cv::Mat_<uchar>(2, 4) << 255, 0, 255, 255, 255, 0, 0, 0);
  const DetectionScore score = comparePixels(detected, truth);
  EXPECT_EQ(score.truePositives, 2U);
  EXPECT_EQ(score.falsePositives, 1U);
  EXPECT_EQ(score.falseNegatives, 2U);
  EXPECT_EQ(score.trueNegatives, 3U);
  EXPECT_DOUBLE_EQ(score.precision(), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(score.recall(), 0.5);
  EXPECT_DOUBLE_EQ(score.spared(), 0.75);
  EXPECT_DOUBLE_EQ(score.iou(), 0.4);
}

TEST(DetectionScore, CountsOneByOneTheSame) {
  const cv::Mat detected = (cv::Mat_<uchar>(1, 5) << 1, 1, 0, 0, 0);
  const cv::Mat truth = (cv::Mat_<uchar>(1, 5) << 1, 0, 1, 0, 0);
  DetectionScore one;
  for (int i = 0; i < 5; ++i) one.add(detected.at<uchar>(i) != 0, truth.at<uchar>(i) != 0);
  const DetectionScore all = comparePixels(detected, truth);
  EXPECT_EQ(one.truePositives, all.truePositives);
  EXPECT_EQ(one.falsePositives, all.falsePositives);
  EXPECT_EQ(one.falseNegatives, all.falseNegatives);
  EXPECT_EQ(one.trueNegatives, all.trueNegatives);
}

TEST(DetectionScore, AddsUp) {
  DetectionScore sum{1, 2, 3, 4};
  sum += {10, 20, 30, 40};
  EXPECT_EQ(sum.truePositives, 11U);
  EXPECT_EQ(sum.falsePositives, 22U);
  EXPECT_EQ(sum.falseNegatives, 33U);
  EXPECT_EQ(sum.trueNegatives, 44U);
}

TEST(DetectionScore, OfNothingIsNoNumber) {
  const DetectionScore nothing;
  EXPECT_TRUE(std::isnan(nothing.precision()));
  EXPECT_TRUE(std::isnan(nothing.recall()));
  EXPECT_TRUE(std::isnan(nothing.spared()));
}

TEST(DetectionScore, RefusesImagesOfDifferentSize) {
  const cv::Mat small(2, 2, CV_8UC1, cv::Scalar(0));
  const cv::Mat large(3, 2, CV_8UC1, cv::Scalar(0));
  EXPECT_THROW(static_cast<void>(comparePixels(small, large)), cv::Exception);
}

}  // namespace
}  // namespace wardslam::evaluation
