#include "wardslam/evaluation/error_statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wardslam::evaluation {
namespace {

TEST(Summarise, WorkedByHand) {
  // Sum 20, sum of squares 16 + 1 + 81 + 4 + 16 = 118, of squared deviations from 4: 0 + 9 + 25 + 4 + 0 = 38.
  const auto statistics = summarise({4, 1, 9, 2, 4});
  EXPECT_EQ(statistics.samples, 5U);
  EXPECT_DOUBLE_EQ(statistics.mean, 4.0);
  EXPECT_DOUBLE_EQ(statistics.rmse, std::sqrt(118.0 / 5.0));
  EXPECT_DOUBLE_EQ(statistics.std, std::sqrt(38.0 / 5.0));
  EXPECT_DOUBLE_EQ(statistics.median, 4.0);
  EXPECT_DOUBLE_EQ(statistics.min, 1.0);
  EXPECT_DOUBLE_EQ(statistics.max, 9.0);
}

TEST(Summarise, TheMedianOfAnEvenNumberLiesBetweenTheMiddleTwo) {
  EXPECT_DOUBLE_EQ(summarise({8, 1, 2, 3}).median, 2.5);
}

TEST(Summarise, OfOneErrorEveryFigureIsThatError) {
  const auto statistics = summarise({3});
  for (const double figure : {statistics.rmse, statistics.mean, statistics.median, statistics.min, statistics.max}) {
    EXPECT_DOUBLE_EQ(figure, 3.0);
  }
  EXPECT_DOUBLE_EQ(statistics.std, 0.0);
}

TEST(Summarise, OfNothingEveryFigureIsNan) {
  const auto statistics = summarise({});
  EXPECT_EQ(statistics.samples, 0U);
  for (const double figure :
       {statistics.rmse, statistics.mean, statistics.median, statistics.std, statistics.min, statistics.max}) {
    EXPECT_TRUE(std::isnan(figure));
  }
}

}  // namespace
}  // namespace wardslam::evaluation
