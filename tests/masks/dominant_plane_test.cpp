#include "dominant_plane.h"

#include <gtest/gtest.h>

namespace wardslam::masks {
namespace {

const cv::Mat kAll(60, 80, CV_8UC1, cv::Scalar(255));

/// A floor 1.2 m below a level camera with a focal length of 60 px and its horizon at row 5, in 1/m: w = (y − 5) / 72.
cv::Mat floorSeen() {
  cv::Mat inverse(60, 80, CV_32FC1, cv::Scalar(0));
  for (int y = 20; y < 60; ++y) inverse.row(y).setTo((y - 5) / 72.0);
  return inverse;
}

TEST(DominantPlane, IsTheFloorAndNotWhatStandsOnIt) {
  cv::Mat inverse = floorSeen();
  const cv::Rect leg(30, 15, 6, 35);
  inverse(leg).setTo((leg.br().y - 5) / 72.0);  // upright where its foot is, in row 49
  const cv::Mat plane = dominantPlane(inverse, kAll, {});
  EXPECT_EQ(cv::countNonZero(plane.rowRange(0, 20)), 0) << "nothing measured, or the leg";
  EXPECT_EQ(cv::countNonZero(plane(cv::Rect(0, 20, 30, 40))), 30 * 40);
  EXPECT_EQ(cv::countNonZero(plane(cv::Rect(30, 15, 6, 30))), 0);
  EXPECT_EQ(cv::countNonZero(plane(cv::Rect(30, 50, 6, 10))), 6 * 10);
}

TEST(DominantPlane, IsLookedForWhereItIsAskedFor) {
  cv::Mat inverse = floorSeen();
  inverse.rowRange(0, 20).setTo(0.25);  // a wall 4 m away
  cv::Mat onWall(60, 80, CV_8UC1, cv::Scalar(0));
  onWall.rowRange(0, 15).setTo(255);
  const cv::Mat plane = dominantPlane(inverse, onWall, {});
  EXPECT_EQ(cv::countNonZero(plane.rowRange(0, 20)), 20 * 80);
  EXPECT_EQ(cv::countNonZero(plane.rowRange(30, 60)), 0);
}

TEST(DominantPlane, ToleratesNoise) {
  cv::Mat inverse = floorSeen();
  cv::Mat noise(inverse.size(), CV_32FC1);
  cv::RNG(3).fill(noise, cv::RNG::NORMAL, 0.0, 0.0019);
  inverse.rowRange(20, 60) += noise.rowRange(20, 60);
  const int found = cv::countNonZero(dominantPlane(inverse, kAll, {}));
  EXPECT_GT(found, 0.95 * 40 * 80) << "within two standard deviations and 1 cm";
}

TEST(DominantPlane, ToleratesTheNoiseOfItsCamera) {
  cv::Mat inverse = floorSeen();
  cv::Mat noise(inverse.size(), CV_32FC1);
  cv::RNG(3).fill(noise, cv::RNG::NORMAL, 0.0, 0.01);
  inverse.rowRange(20, 60) += noise.rowRange(20, 60);
  EXPECT_LT(cv::countNonZero(dominantPlane(inverse, kAll, {})), 0.7 * 40 * 80) << "no Kinect";
  EXPECT_GT(cv::countNonZero(dominantPlane(inverse, kAll, {0.0, 0.01, 0.0})), 0.95 * 40 * 80)
      << "but a pair of cameras";
}

TEST(DominantPlane, IsNothingWhereThereIsNone) {
  EXPECT_EQ(cv::countNonZero(dominantPlane(cv::Mat(60, 80, CV_32FC1, cv::Scalar(0)), kAll, {})), 0);
  cv::Mat rough(60, 80, CV_32FC1);
  cv::RNG(4).fill(rough, cv::RNG::UNIFORM, 0.2, 1.0);
  EXPECT_EQ(cv::countNonZero(dominantPlane(rough, kAll, {})), 0);
  EXPECT_EQ(cv::countNonZero(dominantPlane(floorSeen(), cv::Mat(60, 80, CV_8UC1, cv::Scalar(0)), {})), 0);
}

TEST(DominantPlane, IsRepeatable) {
  cv::Mat inverse = floorSeen();
  inverse(cv::Rect(0, 30, 25, 20)).setTo(0.7);
  EXPECT_EQ(cv::countNonZero(dominantPlane(inverse, kAll, {}) != dominantPlane(inverse, kAll, {})), 0);
}

}  // namespace
}  // namespace wardslam::masks
