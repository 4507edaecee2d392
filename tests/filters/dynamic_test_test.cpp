#include "dynamic_test.h"

#include <gtest/gtest.h>

#include "filters/ward_fixture.h"

namespace wardslam::filters {
namespace {

using core::Motion;
using namespace ward;

knowledge::MotionRules rules() { return {graph(), core::LabelSpace::coco()}; }

DynamicTest testWith(int n, int delta, const cv::Mat& classIds) {
  DynamicTest test(rules(), {n, delta});
  test.setImage(classIds);
  return test;
}

/// A cup (rows 2–4, columns 2–4) held by a person who comes in from the right (columns 5–8), before a bed.
cv::Mat cupInHand() {
  cv::Mat classIds(9, 9, CV_8UC1, cv::Scalar(0));
  classIds(cv::Rect(0, 6, 9, 3)).setTo(kBed);
  classIds(cv::Rect(5, 0, 4, 6)).setTo(kPerson);
  classIds(cv::Rect(2, 2, 3, 3)).setTo(kCup);
  return classIds;
}

TEST(DynamicTest, ThePaperSettingsAreTheDefault) {
  EXPECT_EQ(DynamicTestOptions().n, 21);
  EXPECT_EQ(DynamicTestOptions().delta, 55);
}

TEST(DynamicTest, OnAMovingClassIsDynamicHoweverAlone) {
  cv::Mat classIds(9, 9, CV_8UC1, cv::Scalar(0));
  classIds.at<uchar>(4, 4) = kPerson;
  DynamicTest test = testWith(5, 24, classIds);
  EXPECT_EQ(test.at({4, 4}), Motion::Dynamic);
  EXPECT_EQ(test.at({5, 4}), Motion::Static) << "unclassified, beside it";
}

TEST(DynamicTest, OnAMovableClassCountsTheMoversAround) {
  const cv::Mat classIds = cupInHand();
  // The 5×5 square around (3, 3) has columns 1–5 and rows 1–5: of the person it holds column 5, five pixels.
  EXPECT_EQ(testWith(5, 4, classIds).at({3, 3}), Motion::Dynamic);
  EXPECT_EQ(testWith(5, 5, classIds).at({3, 3}), Motion::Static) << "N_p > delta, not >=";
  // Around (4, 3) it holds columns 5 and 6: ten.
  EXPECT_EQ(testWith(5, 9, classIds).at({4, 3}), Motion::Dynamic);
  EXPECT_EQ(testWith(5, 10, classIds).at({4, 3}), Motion::Static);
  EXPECT_EQ(testWith(3, 0, classIds).at({2, 3}), Motion::Static) << "no person within one pixel";
}

TEST(DynamicTest, OnAStaticClassIsStaticEvenBesideAPerson) {
  DynamicTest test = testWith(5, 0, cupInHand());
  EXPECT_EQ(test.at({6, 6}), Motion::Static) << "bed";
  EXPECT_EQ(test.at({4, 1}), Motion::Static) << "unclassified";
}

TEST(DynamicTest, OnlyWhoCanMoveItCounts) {
  cv::Mat classIds = cupInHand();
  classIds.setTo(kDog, classIds == kPerson);
  EXPECT_EQ(testWith(5, 0, classIds).at({4, 3}), Motion::Static) << "a dog cannot move a cup";
  classIds.setTo(kBall, classIds == kCup);
  EXPECT_EQ(testWith(5, 0, classIds).at({4, 3}), Motion::Dynamic) << "but a ball";

  // Dog and person together move the ball, of the two only the person moves the cup.
  classIds(cv::Rect(5, 0, 4, 3)).setTo(kPerson);
  EXPECT_EQ(testWith(5, 9, classIds).at({4, 3}), Motion::Dynamic) << "4 pixels of person, 6 of dog";
  classIds.setTo(kCup, classIds == kBall);
  EXPECT_EQ(testWith(5, 3, classIds).at({4, 3}), Motion::Dynamic);
  EXPECT_EQ(testWith(5, 4, classIds).at({4, 3}), Motion::Static);
}

TEST(DynamicTest, AMovableThingNobodyCanMoveIsStatic) {
  constexpr core::ClassId kVase = 76;
  cv::Mat classIds = cupInHand();
  classIds.setTo(kVase, classIds == kCup);
  EXPECT_EQ(testWith(5, 0, classIds).at({4, 3}), Motion::Static);
}

TEST(DynamicTest, TheSquareIsCutAtTheBorder) {
  cv::Mat classIds(6, 6, CV_8UC1, cv::Scalar(kPerson));
  classIds.at<uchar>(0, 0) = kCup;
  EXPECT_EQ(testWith(5, 7, classIds).at({0, 0}), Motion::Dynamic) << "3 × 3 pixels are in the image, 8 of a person";
  EXPECT_EQ(testWith(5, 8, classIds).at({0, 0}), Motion::Static);
  EXPECT_EQ(testWith(55, 34, classIds).at({0, 0}), Motion::Dynamic) << "a square larger than the image";
  EXPECT_EQ(testWith(55, 35, classIds).at({0, 0}), Motion::Static);
}

TEST(DynamicTest, APixelOutsideIsTakenToTheBorder) {
  DynamicTest test = testWith(5, 0, cupInHand());
  EXPECT_EQ(test.at({100, -5}), Motion::Dynamic);
  EXPECT_EQ(test.at({-100, 100}), Motion::Static);
}

TEST(DynamicTest, MarksKeyPointsAndKeepsEarlierMarks) {
  DynamicTest test = testWith(5, 4, cupInHand());
  std::vector<core::Keypoint> keypoints = {keypointAt(6.4F, 2.6F), keypointAt(3, 3), keypointAt(1, 7), keypointAt(1, 1),
                                           keypointAt(4.6F, 0.0F)};
  keypoints[3].motion = Motion::Dynamic;
  test.mark(keypoints);
  EXPECT_EQ(keypoints[0].motion, Motion::Dynamic) << "person";
  EXPECT_EQ(keypoints[1].motion, Motion::Dynamic) << "cup in hand";
  EXPECT_EQ(keypoints[2].motion, Motion::Static) << "bed";
  EXPECT_EQ(keypoints[3].motion, Motion::Dynamic) << "marked before";
  EXPECT_EQ(keypoints[4].motion, Motion::Dynamic) << "the nearest pixel is (5, 0)";
}

TEST(DynamicTest, AnotherImageIsAnotherQuestion) {
  DynamicTest test = testWith(5, 4, cupInHand());
  ASSERT_EQ(test.at({3, 3}), Motion::Dynamic);
  cv::Mat leftAlone = cupInHand();
  leftAlone.setTo(0, leftAlone == kPerson);
  test.setImage(leftAlone);
  EXPECT_EQ(test.at({3, 3}), Motion::Static);
}

int countByHand(const cv::Mat& classIds, cv::Point p, int n, const knowledge::ClassSet& movers) {
  int count = 0;
  for (int y = p.y - n / 2; y <= p.y + n / 2; ++y) {
    for (int x = p.x - n / 2; x <= p.x + n / 2; ++x) {
      const bool isInside = x >= 0 && y >= 0 && x < classIds.cols && y < classIds.rows;
      if (isInside && movers[classIds.at<uchar>(y, x)]) ++count;
    }
  }
  return count;
}

class DynamicTestOfSize : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(DynamicTestOfSize, AgreesWithCountingPixelByPixel) {
  const auto [n, delta] = GetParam();
  constexpr std::array<core::ClassId, 7> kClasses = {0, kPerson, kDog, kBall, kCup, kChair, kBed};
  cv::RNG random(n);
  cv::Mat classIds(90, 120, CV_8UC1, cv::Scalar(0));
  for (int i = 0; i < 150; ++i) {  // things of about the size of the square
    const cv::Rect thing(random.uniform(-20, 120), random.uniform(-20, 90), random.uniform(3, 30),
                         random.uniform(3, 30));
    classIds(thing & cv::Rect(0, 0, 120, 90)).setTo(kClasses[random.next() % kClasses.size()]);
  }
  const knowledge::MotionRules ward = rules();
  DynamicTest test = testWith(n, delta, classIds);
  int dynamic = 0;
  int movable = 0;
  for (int y = 0; y < classIds.rows; ++y) {
    for (int x = 0; x < classIds.cols; ++x) {
      const core::ClassId c = classIds.at<uchar>(y, x);
      const bool expected =
          ward.isMoving(c) || (ward.isMovable(c) && countByHand(classIds, {x, y}, n, ward.movers(c)) > delta);
      ASSERT_EQ(test.at({x, y}) == Motion::Dynamic, expected) << x << ", " << y << " on class " << int{c};
      movable += ward.isMovable(c);
      dynamic += ward.isMovable(c) && expected;
    }
  }
  EXPECT_GT(dynamic, 0) << "otherwise this proves little";
  EXPECT_LT(dynamic, movable);
}

INSTANTIATE_TEST_SUITE_P(PaperSettings, DynamicTestOfSize,
                         testing::Values(std::pair{5, 3}, std::pair{21, 55}, std::pair{55, 378}));

}  // namespace
}  // namespace wardslam::filters
