#include "depth_decoder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "segmentation/fake_network.h"

namespace wardslam::segmentation {
namespace {

constexpr int kBackground = 0;
constexpr int kPerson = 1;
constexpr int kChair = 2;

/// Scores of one pixel that give a person this probability and leave the rest to a chair.
cv::Mat scoresOf(double person, cv::Size size = {1, 1}) {
  cv::Mat scores = test::tensor({1, 3, size.height, size.width});
  const auto plane = [&](int c) { return cv::Mat(size, CV_32F, scores.ptr<float>(0, c)); };
  plane(kBackground).setTo(-30.0);
  plane(kPerson).setTo(std::log(person));
  plane(kChair).setTo(std::log(1.0 - person));
  return scores;
}

PixelClasses decode(const cv::Mat& scores, const cv::Mat& depth_m, int person = kPerson) {
  return decodeDepthScores(scores, depth_m, person, {0.3, 0.8});
}

TEST(DepthDecoder, AsksMoreOfAPersonWhereNothingWasMeasured) {
  const cv::Mat depth_m = (cv::Mat_<float>(1, 2) << 2.0F, 0.0F);  // the left pixel was measured
  struct Case {
    double person;
    int measured;
    int unmeasured;
  };
  for (const Case& c :
       {Case{0.25, kChair, kChair}, {0.35, kPerson, kChair}, {0.7, kPerson, kChair}, {0.85, kPerson, kPerson}}) {
    const PixelClasses seen = decode(scoresOf(c.person), depth_m);
    EXPECT_EQ(seen.indices.at<std::uint8_t>(0, 0), c.measured) << c.person;
    EXPECT_EQ(seen.indices.at<std::uint8_t>(0, 1), c.unmeasured) << c.person;
    EXPECT_NEAR(seen.probability.at<float>(0, 0), c.measured == kPerson ? c.person : 1.0 - c.person, 1e-5);
    EXPECT_NEAR(seen.probability.at<float>(0, 1), c.unmeasured == kPerson ? c.person : 1.0 - c.person, 1e-5);
  }
}

TEST(DepthDecoder, TakesTheBestOfAllWhereNobodyIsKnown) {
  const cv::Mat depth_m(1, 1, CV_32F, cv::Scalar(2.0));
  EXPECT_EQ(decode(scoresOf(0.45), depth_m, -1).indices.at<std::uint8_t>(0, 0), kChair);
  EXPECT_EQ(decode(scoresOf(0.55), depth_m, -1).indices.at<std::uint8_t>(0, 0), kPerson);
}

/// Between the middles of two pixels of scores, which are two pixels of the picture apart.
TEST(DepthDecoder, ResamplesProbabilitiesLinearly) {
  cv::Mat scores = scoresOf(0.8, {2, 1});
  cv::Mat(1, 2, CV_32F, scores.ptr<float>(0, kPerson)).at<float>(0, 1) = -30.0F;
  cv::Mat(1, 2, CV_32F, scores.ptr<float>(0, kChair)).at<float>(0, 1) = 0.0F;
  const PixelClasses seen = decode(scores, cv::Mat(2, 4, CV_32F, cv::Scalar(2.0)));
  for (int v = 0; v < 2; ++v) {
    EXPECT_NEAR(seen.probability.at<float>(v, 0), 0.8, 1e-5);
    EXPECT_NEAR(seen.probability.at<float>(v, 1), 0.6, 1e-5);
    EXPECT_EQ(seen.indices.at<std::uint8_t>(v, 1), kPerson);
    EXPECT_EQ(seen.indices.at<std::uint8_t>(v, 2), kChair) << "a person by 0.2";
    EXPECT_NEAR(seen.probability.at<float>(v, 2), 0.8, 1e-5);
    EXPECT_NEAR(seen.probability.at<float>(v, 3), 1.0, 1e-5);
  }
}

TEST(DepthDecoder, MakesNothingOfWhatIsNoNumber) {
  cv::Mat scores = scoresOf(0.5, {2, 2});
  scores.setTo(std::numeric_limits<float>::quiet_NaN());
  const PixelClasses seen = decode(scores, cv::Mat(4, 4, CV_32F, cv::Scalar(2.0)));
  EXPECT_EQ(cv::countNonZero(seen.indices), 0);
  EXPECT_EQ(cv::norm(seen.probability, cv::NORM_INF), 0.0);
}

}  // namespace
}  // namespace wardslam::segmentation
