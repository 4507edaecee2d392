#include "association.h"

#include <gmock/gmock.h>

namespace wardslam::evaluation {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

core::Trajectory atStamps(const std::vector<double>& stamps_s) {
  core::Trajectory trajectory;
  for (const double stamp_s : stamps_s) trajectory.push_back({stamp_s, Eigen::Isometry3d::Identity()});
  return trajectory;
}

/// Pairs as (ground truth, estimate).
std::vector<std::pair<std::size_t, std::size_t>> associated(const std::vector<double>& groundTruth_s,
                                                            const std::vector<double>& estimate_s,
                                                            double maxDifference_s) {
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (const auto& pair : associate(atStamps(groundTruth_s), atStamps(estimate_s), maxDifference_s)) {
    result.emplace_back(pair.groundTruth, pair.estimate);
  }
  return result;
}

// Stamps and limits are sums of powers of two, so that differences are exact.

TEST(Associate, PairsTheNearest) {
  EXPECT_THAT(associated({0, 1, 2, 3}, {1.25, 2.875}, 0.5), ElementsAre(Pair(1, 0), Pair(3, 1)));
}

TEST(Associate, TheLimitItselfIsTooFar) {
  EXPECT_THAT(associated({0, 10}, {0.5, 9.5}, 0.5), IsEmpty());
  EXPECT_THAT(associated({0, 10}, {0.4375, 9.5625}, 0.5), ElementsAre(Pair(0, 0), Pair(1, 1)));
}

TEST(Associate, TheClosestPairIsTakenFirstAndEachPoseOnce) {
  // 1.0-1.125 (0.125) wins over 1.0-0.75 (0.25); then 0.75 takes 0.25, its second choice.
  EXPECT_THAT(associated({0.25, 1.0}, {0.75, 1.125}, 0.75), ElementsAre(Pair(0, 0), Pair(1, 1)));
  // Both estimates are nearest to 1.0; the farther one stays alone.
  EXPECT_THAT(associated({1.0}, {0.75, 1.125}, 0.5), ElementsAre(Pair(0, 1)));
}

TEST(Associate, GreedyLeavesAPoseAloneWhereAnotherChoiceWouldNot) {
  // 1.0-1.25 (0.25) first; 0.5 could only have had 1.0's partner, 1.75 only 1.25's.
  EXPECT_THAT(associated({0.5, 1.25}, {1.0, 1.75}, 0.625), ElementsAre(Pair(1, 0)));
}

TEST(Associate, OfEquallyClosePairsTheEarlierGroundTruthThenTheEarlierEstimateIsTaken) {
  EXPECT_THAT(associated({0.0, 0.5}, {0.25}, 0.5), ElementsAre(Pair(0, 0)));
  EXPECT_THAT(associated({0.25}, {0.0, 0.5}, 0.5), ElementsAre(Pair(0, 0)));
}

TEST(Associate, NothingInCommonGivesNoPairs) {
  EXPECT_THAT(associated({0, 1, 2}, {10, 11}, 0.5), IsEmpty());
  EXPECT_THAT(associated({}, {1}, 0.5), IsEmpty());
  EXPECT_THAT(associated({1}, {}, 0.5), IsEmpty());
}

TEST(Associate, TheBenchmarksLimitIsTheDefault) {
  EXPECT_EQ(associate(atStamps({1.0}), atStamps({1.0195})).size(), 1U);
  EXPECT_EQ(associate(atStamps({1.0}), atStamps({1.0205})).size(), 0U);
}

}  // namespace
}  // namespace wardslam::evaluation
