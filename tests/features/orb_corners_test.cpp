#include "orb_corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

namespace wardslam::features {
namespace {

/// White squares of so many pixels on black, the first at 20, 20, then every 40 pixels; as blurred as a lens leaves
/// them.
cv::Mat squares(const cv::Size& size, int side_px) {
  cv::Mat image(size, CV_8UC1, cv::Scalar(0));
  for (int y = 20; y < size.height; y += 40) {
    for (int x = 20; x < size.width; x += 40) image(cv::Rect(x, y, side_px, side_px) & cv::Rect({}, size)).setTo(255);
  }
  cv::GaussianBlur(image, image, {}, 1.0);
  return image;
}

TEST(OrbPyramid, EveryCopyIsSmallerByTheFactor) {
  const auto pyramid = orbPyramid(squares({640, 480}, 10), 1.2, 3);
  ASSERT_EQ(pyramid.size(), 3U);
  EXPECT_EQ(pyramid[0].size(), cv::Size(640, 480));
  EXPECT_EQ(pyramid[1].size(), cv::Size(533, 400)) << "533.3";
  EXPECT_EQ(pyramid[2].size(), cv::Size(444, 333)) << "444.4 x 333.3";
}

TEST(OrbPyramid, EndsWhereNoPatchHasRoom) {
  EXPECT_EQ(orbPyramid(squares({66, 66}, 10), 2.0, 8).size(), 2U) << "66, 33; not 16";
  EXPECT_TRUE(orbPyramid({}, 1.2, 8).empty());
}

TEST(StrongestCorners, AreThoseOfTheSquaresWithRoomForAPatch) {
  const cv::Mat image = squares({200, 200}, 12);  // corners at 20 to 31, 60 to 71, 100 to 111, 140 to 151; 180 to 191
  const auto corners = strongestCorners(image, 10, 1000);
  ASSERT_FALSE(corners.empty());
  for (const auto& corner : corners) {
    const auto fromGrid = [](float at) { return std::fmod(at - 20.0F + 40.0F, 40.0F); };
    const bool isAtX = fromGrid(corner.pt.x) <= 2 || std::abs(fromGrid(corner.pt.x) - 11) <= 2;
    const bool isAtY = fromGrid(corner.pt.y) <= 2 || std::abs(fromGrid(corner.pt.y) - 11) <= 2;
    EXPECT_TRUE(isAtX && isAtY) << corner.pt;
    EXPECT_TRUE(cv::Rect(16, 16, 168, 168).contains(corner.pt)) << corner.pt;
  }
}

TEST(StrongestCorners, TheWeakerGoFirst) {
  cv::Mat image = squares({200, 200}, 12);
  image.colRange(100, 200) *= 0.2;  // faint ones
  const auto all = strongestCorners(image, 10, 1000);
  const auto isFaint = [](const cv::KeyPoint& corner) { return corner.pt.x > 98; };
  const auto faint = std::count_if(all.begin(), all.end(), isFaint);
  ASSERT_GT(faint, 0);
  const auto most = all.size() - static_cast<std::size_t>(faint);
  const auto strongest = strongestCorners(image, 10, most);
  EXPECT_EQ(strongest.size(), most);
  EXPECT_TRUE(std::none_of(strongest.begin(), strongest.end(), isFaint));
  EXPECT_TRUE(strongestCorners(image, 10, 0).empty());
}

/// OpenCV's ORB works the same measure out on its own.
TEST(StrongestCorners, TheirResponseIsHarris) {
  const cv::Mat image = squares({320, 240}, 12);
  std::vector<cv::KeyPoint> expected;
  cv::ORB::create(1000, 1.2F, 1, 16, 0, 2, cv::ORB::HARRIS_SCORE, kOrbPatch_px, 10)->detect(image, expected);
  const auto corners = strongestCorners(image, 10, 1000);
  std::size_t compared = 0;
  for (const auto& corner : corners) {
    const auto same = std::find_if(expected.begin(), expected.end(), [&](const auto& e) { return e.pt == corner.pt; });
    if (same == expected.end()) continue;
    EXPECT_NEAR(corner.response, same->response, 1e-4F * std::abs(same->response)) << corner.pt;
    ++compared;
  }
  EXPECT_GT(compared, corners.size() / 2);
  EXPECT_GT(compared, 20U);
}

TEST(CentroidAngle, PointsToWhereItIsBright) {
  const cv::Point middle(40, 40);
  const auto angleWith = [&](const cv::Rect& bright) {
    cv::Mat image(81, 81, CV_8UC1, cv::Scalar(10));
    image(bright).setTo(200);
    return centroidAngle_deg(image, middle);
  };
  EXPECT_NEAR(angleWith({41, 0, 40, 81}), 0.0F, 0.5F) << "right";
  EXPECT_NEAR(angleWith({0, 41, 81, 40}), 90.0F, 0.5F) << "below";
  EXPECT_NEAR(angleWith({0, 0, 40, 81}), 180.0F, 0.5F) << "left";
  EXPECT_NEAR(angleWith({0, 0, 81, 40}), 270.0F, 0.5F) << "above";
  EXPECT_NEAR(angleWith({41, 41, 40, 40}), 45.0F, 0.5F);
}

/// What lies outside the circle has no say: 11, 11 is 15.6 px away, 10, 11 is 14.9.
TEST(CentroidAngle, AsksTheCircleAlone) {
  const auto angleWith = [](const cv::Point& bright) {
    cv::Mat image(81, 81, CV_8UC1, cv::Scalar(0));
    image.at<std::uint8_t>(40, 41) = 1;  // to the right, faintly
    image.at<std::uint8_t>(bright) = 255;
    return centroidAngle_deg(image, {40, 40});
  };
  EXPECT_NEAR(angleWith({40 + 11, 40 + 11}), 0.0F, 0.1F);
  EXPECT_GT(angleWith({40 + 10, 40 + 11}), 40.0F);
  EXPECT_NEAR(angleWith({40, 40 + 15}), 90.0F, 0.5F) << "the edge is in it";
  EXPECT_NEAR(angleWith({40, 40 + 16}), 0.0F, 0.1F);
}

}  // namespace
}  // namespace wardslam::features
