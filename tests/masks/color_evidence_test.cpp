#include "color_evidence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wardslam::masks {
namespace {

const cv::Scalar kRed(20, 20, 200);
const cv::Scalar kBlue(200, 20, 20);
const cv::Scalar kGreen(20, 200, 20);

/// Three stripes of 20 columns each.
cv::Mat stripes(const cv::Scalar& left, const cv::Scalar& middle, const cv::Scalar& right) {
  cv::Mat image(20, 60, CV_8UC3, left);
  image.colRange(20, 40).setTo(middle);
  image.colRange(40, 60).setTo(right);
  return image;
}

cv::Mat columns(int begin, int end) {
  cv::Mat mask(20, 60, CV_8UC1, cv::Scalar(0));
  mask.colRange(begin, end).setTo(255);
  return mask;
}

TEST(BackgroundEvidence, IsTheLogarithmOfTheRatioOfProbabilities) {
  const cv::Mat evidence = backgroundEvidence(stripes(kRed, kBlue, kRed), columns(0, 20), columns(20, 40));
  // All 400 pixels of either have one colour; 1/4096 stands for what was never seen.
  const double expected = std::log((400.0 / 401.0 + 1.0 / 4096) / (1.0 / 4096));
  EXPECT_NEAR(evidence.at<float>(10, 10), -expected, 1e-4);
  EXPECT_NEAR(evidence.at<float>(10, 30), expected, 1e-4);
  EXPECT_NEAR(evidence.at<float>(10, 50), -expected, 1e-4) << "colours count wherever they are";
}

TEST(BackgroundEvidence, SaysNothingOfColoursNeverSeenOrSeenInBoth) {
  const cv::Mat unseen = backgroundEvidence(stripes(kRed, kBlue, kGreen), columns(0, 20), columns(20, 40));
  EXPECT_NEAR(unseen.at<float>(10, 50), 0.0, 1e-6);
  const cv::Mat inBoth = backgroundEvidence(stripes(kRed, kRed, kGreen), columns(0, 20), columns(20, 40));
  EXPECT_NEAR(inBoth.at<float>(10, 10), 0.0, 1e-6);
}

TEST(BackgroundEvidence, IsTheMeanOfFiveByFivePixels) {
  const cv::Mat evidence = backgroundEvidence(stripes(kRed, kBlue, kRed), columns(0, 20), columns(20, 40));
  EXPECT_NEAR(evidence.at<float>(10, 20), evidence.at<float>(10, 30) / 5, 1e-4) << "3 columns for, 2 against";
}

}  // namespace
}  // namespace wardslam::masks
