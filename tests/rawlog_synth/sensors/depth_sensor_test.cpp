#include "sensors/depth_sensor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wardslam::synth {
namespace {

const cv::Size kSize(320, 240);

cv::Mat wall(double z_m) { return {kSize, CV_32FC1, cv::Scalar(z_m)}; }
cv::Mat light(double gray) { return {kSize, CV_8UC3, cv::Scalar::all(gray)}; }

/// A near thing in front of a wall, from column 100 to 199.
cv::Mat thingAhead() {
  cv::Mat scene = wall(3.0);
  scene.colRange(100, 200).setTo(1.5);
  return scene;
}

std::pair<double, double> statistics(const cv::Mat& measured_m) {
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(measured_m, mean, deviation, measured_m > 0);
  return {mean[0], deviation[0]};
}

TEST(TimeOfFlight, ErrorsGrowWithDistanceAndDarknessAsTheFormulaSays) {
  EXPECT_NEAR(tofSigma_m(2.0, 1.0), 0.0045, 1e-12);
  EXPECT_NEAR(tofSigma_m(2.0, 0.25), 0.0075, 1e-12);
  for (const double gray : {255.0, 64.0}) {
    const auto [mean_m, deviation_m] = statistics(measureByTof(wall(4.0), light(gray), 1.0, 7));
    const double expected_m = tofSigma_m(4.0, gray / 255);
    EXPECT_NEAR(deviation_m, expected_m, 0.03 * expected_m);
    EXPECT_NEAR(mean_m, 4.0, 0.05 * expected_m);
  }
}

TEST(TimeOfFlight, BlackThingsFarAwayReturnNothing) {
  EXPECT_EQ(cv::countNonZero(measureByTof(wall(6.0), light(10), 1.0, 7)), 0);
  EXPECT_EQ(cv::countNonZero(measureByTof(wall(1.0), light(10), 1.0, 7)), kSize.area());
}

TEST(TimeOfFlight, PixelsFlyBetweenBothSidesOfAnEdgeOnly) {
  const cv::Mat measured = measureByTof(thingAhead(), light(200), 1.0, 3);
  const cv::Mat between = (measured > 1.6) & (measured < 2.9);
  EXPECT_EQ(cv::countNonZero(between.colRange(0, 98)), 0);
  EXPECT_EQ(cv::countNonZero(between.colRange(102, 198)), 0);
  EXPECT_GT(cv::countNonZero(between.colRange(98, 102)), 100);
}

TEST(ActiveStereo, ErrorsGrowWithTheSquareOfTheDistance) {
  EXPECT_NEAR(stereoSigma_m(2.0, 400.0), 0.016, 1e-12);
  for (const double z_m : {1.0, 2.0, 4.0}) {
    const auto [mean_m, deviation_m] = statistics(measureByStereo(wall(z_m), 262.5, 1.0, 7));
    const double step_m = z_m * z_m / (32 * 262.5 * 0.05);
    const double expected_m = std::hypot(stereoSigma_m(z_m, 262.5), step_m / std::sqrt(12.0));
    EXPECT_NEAR(deviation_m, expected_m, 0.1 * expected_m) << z_m;
    EXPECT_NEAR(mean_m, z_m, 0.2 * expected_m) << z_m;
  }
}

TEST(ActiveStereo, NeighboursErrAlike) {
  const cv::Mat error_m = measureByStereo(wall(2.0), 262.5, 1.0, 7) - 2.0;
  const double variance = error_m.dot(error_m) / kSize.area();
  const cv::Mat left = error_m.colRange(0, 319);
  const double covariance = left.dot(error_m.colRange(1, 320)) / (319 * 240);
  EXPECT_GT(covariance / variance, 0.3);
}

TEST(ActiveStereo, NearThingsAreFatAndHideWhatIsLeftOfThem) {
  const cv::Mat measured = measureByStereo(thingAhead(), 262.5, 0.01, 3);
  // The shadow: f b (1 / 1.5 m - 1 / 3 m) = 4.4 px to the left; half a block more of the thing on both sides.
  EXPECT_EQ(cv::countNonZero(measured.col(96)), 0);
  EXPECT_NEAR(measured.at<float>(120, 93), 3.0F, 0.1F);
  EXPECT_NEAR(measured.at<float>(120, 201), 1.5F, 0.1F);
  EXPECT_NEAR(measured.at<float>(120, 204), 3.0F, 0.1F);
}

TEST(DepthSensors, WithoutNoiseMeasureTheTruthWithinTheirRange) {
  EXPECT_EQ(cv::norm(measureByTof(thingAhead(), light(100), 0.0, 1), thingAhead(), cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(measureByStereo(thingAhead(), 262.5, 0.0, 1), thingAhead(), cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::countNonZero(measureByTof(wall(9.0), light(255), 0.0, 1)), 0);
  EXPECT_EQ(cv::countNonZero(measureByStereo(wall(0.15), 262.5, 0.0, 1)), 0);
}

TEST(DepthSensors, TheSeedDecides) {
  const cv::Mat tof = measureByTof(wall(2.0), light(100), 1.0, 1);
  EXPECT_EQ(cv::norm(tof, measureByTof(wall(2.0), light(100), 1.0, 1), cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(tof, measureByTof(wall(2.0), light(100), 1.0, 2), cv::NORM_INF), 0.0);
}

}  // namespace
}  // namespace wardslam::synth
