#include "sensors/exposure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wardslam::synth {
namespace {

const cv::Mat kGray(120, 160, CV_8UC3, cv::Scalar::all(120));

KinectOptions plainChip() {
  KinectOptions chip;
  chip.vignetting = 0.0;
  return chip;
}

std::pair<double, double> statistics(const cv::Mat& image) {
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(image, mean, deviation);
  return {mean[1], deviation[1]};
}

TEST(Exposure, InGoodLightIsWhatItAlwaysWas) {
  EXPECT_EQ(cv::norm(expose(kGray, {}, plainChip(), 1.0, 3), exposeColor(kGray, plainChip(), 3), cv::NORM_INF), 0.0);
}

TEST(Exposure, InTheDarkOnlyNoiseIsLeft) {
  ExposureOptions dark;
  dark.isDark = true;
  const auto [mean, deviation] = statistics(expose(kGray, dark, plainChip(), 1.0, 3));
  EXPECT_LT(mean, 8.0);
  EXPECT_GT(deviation, 2.0);
}

TEST(Exposure, BrightnessAndNoiseFollowTheGain) {
  ExposureOptions jumping;
  jumping.jumps = true;
  const auto [brightMean, brightDeviation] = statistics(expose(kGray, jumping, plainChip(), 1.5, 3));
  EXPECT_NEAR(brightMean, 180.0, 0.2);
  EXPECT_NEAR(brightDeviation, 1.5 * 1.6, 0.15);
  const auto [dimMean, dimDeviation] = statistics(expose(kGray, jumping, plainChip(), 0.5, 3));
  EXPECT_NEAR(dimMean, 60.0, 0.2);
  EXPECT_NEAR(dimDeviation, 1.6, 0.1);
}

TEST(Exposure, GainJumpsNowAndThenWithinBounds) {
  double least = 10.0;
  double most = 0.0;
  int jumps = 0;
  for (double t_s = 0; t_s < 60.0; t_s += 1.0 / 30) {
    const double gain = gainAt(t_s, 1);
    least = std::min(least, gain);
    most = std::max(most, gain);
    jumps += std::abs(std::log2(gainAt(t_s + 1.0 / 30, 1) / gain)) > 0.08 ? 1 : 0;
  }
  EXPECT_GE(least, 0.4);
  EXPECT_LE(most, 2.3);
  EXPECT_LT(least, 0.7);
  EXPECT_GT(most, 1.4);
  EXPECT_GT(jumps, 10) << "of about one in three seconds, some to a value close by";
  EXPECT_LT(jumps, 300) << "most of the time it stays";
}

TEST(Exposure, GainDependsOnSeedAndTimeAlone) {
  EXPECT_EQ(gainAt(12.3, 5), gainAt(12.3, 5));
  EXPECT_NE(gainAt(12.3, 5), gainAt(12.3, 6));
}

TEST(Exposure, ALongSmearTakesMoreRenderings) {
  EXPECT_EQ(blurSamples(0.0), 3);
  EXPECT_EQ(blurSamples(8.0), 5);
  EXPECT_EQ(blurSamples(500.0), 12);
}

}  // namespace
}  // namespace wardslam::synth
