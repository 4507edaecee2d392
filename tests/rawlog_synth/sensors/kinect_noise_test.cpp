#include "sensors/kinect_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

namespace wardslam::synth {
namespace {

cv::Mat wall(double z_m) { return {480, 640, CV_32FC1, cv::Scalar(z_m)}; }

/// Mean and standard deviation of what was measured; the image's right part is free of the projector's shadow.
std::pair<double, double> statistics(const cv::Mat& measured_m) {
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(measured_m, mean, deviation, measured_m > 0);
  return {mean[0], deviation[0]};
}

TEST(KinectNoise, SigmaIsThePublishedFormula) {
  EXPECT_DOUBLE_EQ(axialSigma_m(0.4), 0.0012);
  EXPECT_NEAR(axialSigma_m(2.4), 0.0088, 1e-12);
}

TEST(KinectNoise, QuantisationStepGrowsWithTheSquareOfTheDepth) {
  // Two neighbouring disparities around 4 m, by hand: f b = 39.375 px m, d = 9.84375 px.
  const KinectOptions options;
  const double next_m = 39.375 / (9.84375 - 0.125) - 4.0;
  EXPECT_NEAR(quantisationStep_m(4.0, options), next_m, 0.02 * next_m);
  EXPECT_NEAR(quantisationStep_m(2.0, options), quantisationStep_m(4.0, options) / 4, 1e-12);
}

class NoiseOfAWall : public testing::TestWithParam<double> {};

TEST_P(NoiseOfAWall, IsUnbiasedAndAsLargeAsTheFormulaSays) {
  const double z_m = GetParam();
  const KinectOptions options;
  const auto [mean_m, deviation_m] = statistics(measureDepth(wall(z_m), options, 7));
  const double step_m = quantisationStep_m(z_m, options);
  const double expected_m = std::hypot(axialSigma_m(z_m), step_m / std::sqrt(12.0));
  EXPECT_NEAR(deviation_m, expected_m, 0.12 * expected_m);
  EXPECT_NEAR(mean_m, z_m, 0.1 * expected_m);
}

INSTANTIATE_TEST_SUITE_P(Depths, NoiseOfAWall, testing::Values(1.5, 3.0, 5.0, 6.5));

TEST(KinectNoise, DepthsAreThoseOfWholeDisparitySteps) {
  const KinectOptions options;
  const cv::Mat measured = measureDepth(wall(3.0), options, 7);
  for (int x = 0; x < measured.cols; ++x) {
    const double disparity_steps = 525.0 * 0.075 / 0.125 / static_cast<double>(measured.at<float>(100, x));
    EXPECT_NEAR(disparity_steps, std::round(disparity_steps), 1e-3);
  }
}

TEST(KinectNoise, NothingIsMeasuredOutOfRange) {
  const KinectOptions options;
  EXPECT_EQ(cv::countNonZero(measureDepth(wall(0.35), options, 1)), 0);
  EXPECT_EQ(cv::countNonZero(measureDepth(wall(9.0), options, 1)), 0);
  EXPECT_EQ(cv::countNonZero(measureDepth(cv::Mat::zeros(480, 640, CV_32FC1), options, 1)), 0);
}

TEST(KinectNoise, AnObjectCastsTheProjectorsShadowToItsLeft) {
  KinectOptions options;
  options.edgeHoles = 0.0;
  cv::Mat scene = wall(4.0);
  scene(cv::Rect(300, 0, 100, 480)).setTo(1.0);
  const cv::Mat measured = measureDepth(scene, options, 3);
  // f b (1 / 1 m - 1 / 4 m) = 29.5 px
  EXPECT_EQ(measured.at<float>(240, 285), 0.0F);
  EXPECT_EQ(measured.at<float>(240, 272), 0.0F);
  EXPECT_GT(measured.at<float>(240, 268), 3.0F);
  EXPECT_GT(measured.at<float>(240, 402), 3.0F);
  EXPECT_NEAR(measured.at<float>(240, 350), 1.0F, 0.05F);
}

TEST(KinectNoise, EdgesHaveHoles) {
  KinectOptions options;
  options.edgeHoles = 1.0;
  cv::Mat scene = wall(4.0);
  scene(cv::Rect(300, 200, 100, 100)).setTo(3.0);
  const cv::Mat measured = measureDepth(scene, options, 3);
  EXPECT_EQ(measured.at<float>(200, 350), 0.0F);
  EXPECT_EQ(measured.at<float>(250, 399), 0.0F);
  EXPECT_GT(measured.at<float>(250, 350), 0.0F);
}

TEST(KinectNoise, WithoutNoiseTheDepthIsKept) {
  KinectOptions options;
  options.depthNoise = 0.0;
  EXPECT_EQ(cv::norm(measureDepth(wall(3.3), options, 1), wall(3.3), cv::NORM_INF), 0.0);
}

TEST(KinectNoise, TheSeedDecides) {
  const KinectOptions options;
  const cv::Mat one = measureDepth(wall(3.0), options, 1);
  EXPECT_EQ(cv::norm(one, measureDepth(wall(3.0), options, 1), cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(one, measureDepth(wall(3.0), options, 2), cv::NORM_INF), 0.0);
}

TEST(KinectNoise, ColourGetsNoiseOfTheAskedSize) {
  KinectOptions options;
  options.vignetting = 0.0;
  options.imageNoise = 4.0;
  const cv::Mat gray(480, 640, CV_8UC3, cv::Scalar::all(120));
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(exposeColor(gray, options, 5), mean, deviation);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(mean[c], 120.0, 0.1);
    EXPECT_NEAR(deviation[c], 4.0, 0.1);
  }
}

TEST(KinectNoise, CornersAreDarkerByTheVignetting) {
  KinectOptions options;
  options.vignetting = 0.25;
  options.imageNoise = 0.0;
  const cv::Mat white(481, 641, CV_8UC3, cv::Scalar::all(200));
  const cv::Mat exposed = exposeColor(white, options, 5);
  EXPECT_EQ(exposed.at<cv::Vec3b>(240, 320), cv::Vec3b(200, 200, 200));
  EXPECT_EQ(exposed.at<cv::Vec3b>(0, 0), cv::Vec3b(150, 150, 150));
}

}  // namespace
}  // namespace wardslam::synth
