#include "wardslam/graph/loop_verification.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "graph/synthetic_walk.h"

namespace wardslam::graph {
namespace {

using test::makePose;

/// A round and one step more: the last keyframe stands where the second stood.
class LoopVerificationTest : public ::testing::Test {
 protected:
  static constexpr KeyframeId kOlder = 2;
  static constexpr KeyframeId kNewer = test::SyntheticWalk::kKeyframesPerRound + 2;

  /// `slip` happens half way round.
  void walk(const Eigen::Isometry3d& slip = Eigen::Isometry3d::Identity()) {
    for (KeyframeId id = 1; id < kNewer; ++id) {
      graph_.insert(walk_.step(id == kNewer / 2 ? slip : Eigen::Isometry3d::Identity()));
    }
    last_ = walk_.step();
  }

  [[nodiscard]] std::optional<Loop> verify() {
    graph_.insert(last_);
    const LoopVerification verification(options_, odometry::MatcherOptions{}, odometry::PoseSolverOptions{});
    return verification.verify(graph_, kNewer, verification.placeAround(graph_, kOlder));
  }

  LoopVerificationOptions options_;
  test::SyntheticWalk walk_{{0.5, 0.5, 10}};
  KeyframeGraph graph_;
  std::shared_ptr<odometry::Keyframe> last_;
};

TEST_F(LoopVerificationTest, FindsWhereAKeyframeStandsAtAnOldPlace) {
  walk(makePose({0.1, 0.0, 0.15}, {0.0, 0.05, 0.0}));
  const auto loop = verify();
  ASSERT_TRUE(loop);
  EXPECT_EQ(loop->older, kOlder);
  EXPECT_EQ(loop->newer, kNewer);
  EXPECT_LT(loop->T_older_newer.translation().norm(), 0.01) << "the same place, though the map says otherwise";
  EXPECT_LT(test::angle_rad(loop->T_older_newer, Eigen::Isometry3d::Identity()), 0.005);
  EXPECT_THAT(loop->place, testing::Contains(kOlder));
  ASSERT_GT(loop->samePoints.size(), 100U);
  for (const auto& [from, into] : loop->samePoints) {
    EXPECT_NE(from, into);
    EXPECT_EQ(walk_.worldPointOf(from), walk_.worldPointOf(into));
  }
}

TEST_F(LoopVerificationTest, TiesTheLoopToTheNearestKeyframeOfThePlace) {
  walk();
  graph_.insert(last_);
  const LoopVerification verification(options_, odometry::MatcherOptions{}, odometry::PoseSolverOptions{});
  const auto loop = verification.verify(graph_, kNewer, {kOlder + 1, kOlder, kOlder - 1});
  ASSERT_TRUE(loop);
  EXPECT_EQ(loop->older, kOlder);
}

TEST_F(LoopVerificationTest, RefusesACorrectionThatDriftCannotExplain) {
  walk(makePose({0.5, 0.0, 0.0}));  // more than 3.5 standard deviations of a way of 6 m, and 0.3 m
  EXPECT_FALSE(verify());
}

TEST_F(LoopVerificationTest, BelievesMoreDriftWhenToldSo) {
  walk(makePose({0.5, 0.0, 0.0}));
  options_.position_drift = 0.1;
  EXPECT_TRUE(verify());
}

TEST_F(LoopVerificationTest, BelievesAnyCorrectionBetweenSubmaps) {
  walk(makePose({0.5, 0.0, 0.0}));
  last_->submap = 2;
  last_->T_map_cam = makePose({50.0, 0.0, 0.0});
  const auto loop = verify();
  ASSERT_TRUE(loop);
  EXPECT_LT(loop->T_older_newer.translation().norm(), 0.01);
}

TEST_F(LoopVerificationTest, RefusesTheSameLooksInAnotherOrder) {
  walk();
  auto& keypoints = last_->features.keypoints;
  std::rotate(keypoints.begin(), keypoints.begin() + static_cast<std::ptrdiff_t>(keypoints.size() / 2),
              keypoints.end());
  EXPECT_FALSE(verify());
}

TEST_F(LoopVerificationTest, RefusesAPictureOfThePlace) {
  walk();
  for (auto& keypoint : last_->features.keypoints) keypoint.depth_m = 1.0F;  // flat, on a wall
  EXPECT_FALSE(verify());
}

TEST_F(LoopVerificationTest, RefusesWhenTooLittleOfThePlaceIsFound) {
  walk();
  const auto seen = last_->features.size();
  options_.min_inliers = static_cast<int>(seen) + 1;
  EXPECT_FALSE(verify());
}

}  // namespace
}  // namespace wardslam::graph
