#include "wardslam/masks/image_motion.h"

#include <gtest/gtest.h>

#include "masks/textured_scene.h"

namespace wardslam::masks {
namespace {

using namespace scene;

SmallPicture pictureOf(const Picture& picture, double stamp_s = 0.0) {
  return shrink(picture.gray, picture.depth_m, stamp_s);
}

/// Median of a field of vectors within a part of the image.
cv::Vec2f medianOf(const cv::Mat& field, cv::Rect part) {
  std::vector<float> x;
  std::vector<float> y;
  for (const auto& v : cv::Mat_<cv::Vec2f>(field(part))) {
    x.push_back(v[0]);
    y.push_back(v[1]);
  }
  std::nth_element(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2), x.end());
  std::nth_element(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(y.size() / 2), y.end());
  return {x[x.size() / 2], y[y.size() / 2]};
}

TEST(Shrink, HalvesAFullPictureAndKeepsDepthsApart) {
  cv::Mat gray(480, 640, CV_8UC1, cv::Scalar(10));
  gray(cv::Rect(0, 0, 640, 1)).setTo(30);
  cv::Mat depth_m(480, 640, CV_32FC1, cv::Scalar(1));
  depth_m(cv::Rect(321, 0, 319, 480)).setTo(4);
  const SmallPicture picture = shrink(gray, depth_m, 7.5);
  EXPECT_EQ(picture.stamp_s, 7.5);
  EXPECT_EQ(picture.gray.size(), cv::Size(320, 240));
  EXPECT_EQ(picture.depth_m.size(), cv::Size(320, 240));
  EXPECT_EQ(picture.gray.at<std::uint8_t>(0, 5), 20) << "mean of two rows";
  EXPECT_EQ(cv::countNonZero((picture.depth_m == 1) | (picture.depth_m == 4)), 320 * 240) << "no depth in between";
}

TEST(Shrink, WithoutDepthThereIsNoneAnywhere) {
  const SmallPicture picture = shrink(cv::Mat(60, 80, CV_8UC1, cv::Scalar(0)), {}, 0.0);
  EXPECT_EQ(picture.gray.size(), cv::Size(80, 60)) << "small already";
  EXPECT_EQ(picture.depth_m.type(), CV_32FC1);
  EXPECT_EQ(cv::countNonZero(picture.depth_m), 0);
}

TEST(ImageMotion, TellsWhereThingsWereBefore) {
  Picture before = wall(4.0);
  Picture now = wall(4.0, {3, -2});  // what was at (x, y) is at (x - 3, y + 2)
  put(before, 1, kPerson, {100, 60, 80, 100}, 2.0);
  put(now, 1, kPerson, {105, 61, 80, 100}, 2.0);
  ImageMotion motion;
  motion.advance(pictureOf(before));
  EXPECT_TRUE(motion.step().empty());
  motion.advance(pictureOf(now));
  ASSERT_EQ(motion.step().type(), CV_32FC2);
  const cv::Vec2f ofWall = medianOf(motion.step(), {220, 40, 80, 160});
  EXPECT_NEAR(ofWall[0], 3, 0.2);
  EXPECT_NEAR(ofWall[1], -2, 0.2);
  const cv::Vec2f ofThing = medianOf(motion.step(), {120, 75, 50, 70});
  EXPECT_NEAR(ofThing[0], -5, 0.2);
  EXPECT_NEAR(ofThing[1], -1, 0.2);
}

TEST(ImageMotion, StartsAnewAfterAPictureOfAnotherSize) {
  ImageMotion motion;
  motion.advance(pictureOf(wall(4.0)));
  motion.advance(shrink(texture(3, {160, 120}), {}, 0.0));
  EXPECT_TRUE(motion.step().empty());
  EXPECT_EQ(motion.picture().gray.size(), cv::Size(160, 120));
  motion.advance(shrink(texture(3, {160, 120}), {}, 0.1));
  EXPECT_FALSE(motion.step().empty());
}

TEST(ImageMotion, APictureTooSmallToFollowStands) {
  ImageMotion motion;
  motion.advance(shrink(texture(3, {20, 16}), {}, 0.0));
  motion.advance(shrink(texture(4, {20, 16}), {}, 0.1));
  ASSERT_EQ(motion.step().size(), cv::Size(20, 16));
  EXPECT_EQ(cv::norm(motion.step()), 0.0);
}

TEST(Trail, BeginsWhereItIs) {
  const Trail trail(pictureOf(wall(4.0), 3.0));
  EXPECT_EQ(trail.steps(), 0);
  EXPECT_EQ(trail.start().stamp_s, 3.0);
  EXPECT_EQ(trail.places().at<cv::Vec2f>(17, 40), cv::Vec2f(40, 17));
}

TEST(Trail, JoinsSteps) {
  Trail trail(pictureOf(wall(4.0)));
  const cv::Size size(kWidth_px, kHeight_px);
  trail.follow(cv::Mat(size, CV_32FC2, cv::Scalar(3, 0)));
  // The left half came from two pixels above, the right half stood.
  cv::Mat step(size, CV_32FC2, cv::Scalar(0, 0));
  step(cv::Rect(0, 0, kWidth_px / 2, kHeight_px)).setTo(cv::Scalar(0, -2));
  trail.follow(step);
  EXPECT_EQ(trail.steps(), 2);
  EXPECT_EQ(trail.places().at<cv::Vec2f>(50, 40), cv::Vec2f(43, 48));
  EXPECT_EQ(trail.places().at<cv::Vec2f>(50, 200), cv::Vec2f(203, 50));
}

TEST(Trail, OfALongWalkAddsUp) {
  ImageMotion motion;
  motion.advance(pictureOf(wall(4.0)));
  Trail trail(motion.picture());
  for (int i = 1; i <= 8; ++i) {
    motion.advance(pictureOf(wall(4.0, {4 * i, i})));
    trail.follow(motion.step());
  }
  const cv::Mat moved = trail.places() - Trail(motion.picture()).places();
  const cv::Vec2f way = medianOf(moved, {60, 60, 150, 120});
  EXPECT_NEAR(way[0], 32, 1.0);
  EXPECT_NEAR(way[1], 8, 1.0);
}

}  // namespace
}  // namespace wardslam::masks
