#include "even_spread.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

namespace wardslam::features {
namespace {

using testing::ElementsAre;

cv::KeyPoint keypoint(float x_px, float y_px, float response) { return {x_px, y_px, 31.0F, -1.0F, response}; }

/// The responses of what was chosen, in order.
std::vector<float> chosen(const std::vector<cv::KeyPoint>& keypoints, std::size_t count, int cellSize_px = 10) {
  std::vector<float> responses;
  for (const auto& kept : spreadEvenly(keypoints, count, cellSize_px)) responses.push_back(kept.response);
  return responses;
}

// Three cells of 10 px: the left one is rich and strong, the middle one has two points, the right one a weak one.
const std::vector<cv::KeyPoint> kThreeCells = {keypoint(1, 1, 90), keypoint(2, 2, 80),  keypoint(3, 3, 70),
                                               keypoint(4, 4, 60), keypoint(11, 5, 50), keypoint(12, 5, 40),
                                               keypoint(25, 5, 10)};

TEST(EvenSpread, CellsTakeTurnsInGivingTheirStrongest) {
  EXPECT_THAT(chosen(kThreeCells, 3), ElementsAre(90, 50, 10)) << "first turn: one of each cell, strongest first";
  EXPECT_THAT(chosen(kThreeCells, 5), ElementsAre(90, 50, 10, 80, 40)) << "second turn: the right cell has no more";
  EXPECT_THAT(chosen(kThreeCells, 6), ElementsAre(90, 50, 10, 80, 40, 70));
}

TEST(EvenSpread, ATurnCutShortGoesToTheStrongestCells) {
  EXPECT_THAT(chosen(kThreeCells, 2), ElementsAre(90, 50));
  EXPECT_THAT(chosen(kThreeCells, 4), ElementsAre(90, 50, 10, 80));
}

TEST(EvenSpread, GivesAllWhereThereAreFewerThanAsked) {
  EXPECT_THAT(chosen(kThreeCells, 100), ElementsAre(90, 50, 10, 80, 40, 70, 60));
  EXPECT_THAT(chosen(kThreeCells, 0), ElementsAre());
  EXPECT_THAT(chosen({}, 5), ElementsAre());
}

TEST(EvenSpread, CellsBeginAtMultiplesOfTheirSize) {
  // 9.9 and 10.0 are neighbours in different cells, above each other as well as beside.
  EXPECT_THAT(chosen({keypoint(9.9F, 0, 9), keypoint(9, 0, 8), keypoint(10, 0, 1)}, 2), ElementsAre(9, 1));
  EXPECT_THAT(chosen({keypoint(0, 9.9F, 9), keypoint(0, 9, 8), keypoint(0, 10, 1)}, 2), ElementsAre(9, 1));
  EXPECT_THAT(chosen({keypoint(9.9F, 0, 9), keypoint(9, 0, 8), keypoint(10, 0, 1)}, 2, 20), ElementsAre(9, 8));
}

TEST(EvenSpread, TiesAreBrokenByPositionRowFirst) {
  const auto spread = spreadEvenly({keypoint(5, 2, 7), keypoint(6, 1, 7), keypoint(4, 2, 7)}, 3, 10);
  EXPECT_EQ(spread[0].pt, cv::Point2f(6, 1));
  EXPECT_EQ(spread[1].pt, cv::Point2f(4, 2));
  EXPECT_EQ(spread[2].pt, cv::Point2f(5, 2));
}

TEST(EvenSpread, DoesNotDependOnTheOrderOfItsInput) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> pixel(0, 199);
  std::uniform_int_distribution<int> strength(1, 5);  // so that many are equal
  std::vector<cv::KeyPoint> keypoints;
  for (int i = 0; i < 500; ++i) {
    keypoints.push_back(keypoint(static_cast<float>(pixel(random)),
                                 static_cast<float>(pixel(random)) + 1e-3F * static_cast<float>(i),
                                 static_cast<float>(strength(random))));
  }
  const auto positions = [](const std::vector<cv::KeyPoint>& some) {
    std::vector<cv::Point2f> px;
    cv::KeyPoint::convert(some, px);
    return px;
  };
  const auto expected = positions(spreadEvenly(keypoints, 120, 32));
  ASSERT_EQ(expected.size(), 120U);
  std::shuffle(keypoints.begin(), keypoints.end(), random);
  EXPECT_EQ(positions(spreadEvenly(keypoints, 120, 32)), expected);
}

}  // namespace
}  // namespace wardslam::features
