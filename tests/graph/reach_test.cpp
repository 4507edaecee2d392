#include "reach.h"

#include <gtest/gtest.h>

#include "graph/synthetic_walk.h"

namespace wardslam::graph {
namespace {

using test::makePose;

/// Keyframes a second apart; each step says how far it led, in x, and whether tracking was lost before it.
class ReachTest : public ::testing::Test {
 protected:
  void go(double way_m, double after_s = 1.0) { add(way_m, after_s); }
  void loseAndGo(double after_s) {
    ++submap_;
    x_m_ = 0.0;
    add(0.0, after_s);
  }

  /// A loop by which the newest keyframe stands `x_m` from the first one.
  [[nodiscard]] bool isWithinReach(double x_m) const {
    const Loop loop{1, graph_.keyframes().rbegin()->first, makePose({x_m, 0, 0}), 100, {}, {1}};
    return graph::isWithinReach(graph_, loop, options_);
  }

  /// The newest keyframe began its piece at x = 0, and that was `x_m` from the first one.
  [[nodiscard]] double ambiguity_m(double x_m) const {
    const KeyframeId newest = graph_.keyframes().rbegin()->first;
    const Loop loop{1, newest, makePose({x_m, 0, 0}) * graph_.keyframes().at(newest).T_map_cam, 100, {}, {1}};
    return graph::ambiguity_m(graph_, loop, options_).value();
  }

  LoopVerificationOptions options_;
  KeyframeGraph graph_;

 private:
  void add(double way_m, double after_s) {
    auto keyframe = std::make_shared<odometry::Keyframe>();
    keyframe->id = graph_.keyframes().empty() ? 1 : graph_.keyframes().rbegin()->first + 1;
    keyframe->submap = submap_;
    keyframe->stamp_s = stamp_s_ += after_s;
    keyframe->T_map_cam = makePose({x_m_ += way_m, 0, 0});
    keyframe->T_previous_cam = makePose({way_m, 0, 0});
    graph_.insert(keyframe);
  }

  std::uint32_t submap_ = 1;
  double stamp_s_ = 1700000000.0;
  double x_m_ = 0.0;
};

TEST_F(ReachTest, IsWhatTheCameraCanHaveGoneWhileLost) {
  go(0.0);
  go(2.0);         // to x = 2
  loseAndGo(4.0);  // 1 m and 1.5 m/s: 7 m
  EXPECT_TRUE(isWithinReach(8.9));
  EXPECT_TRUE(isWithinReach(-4.9));
  EXPECT_FALSE(isWithinReach(9.1));
  EXPECT_FALSE(isWithinReach(-5.1));
}

TEST_F(ReachTest, TakesAPieceInBetweenForAsFarAsItLed) {
  go(0.0);
  loseAndGo(2.0);                                       // 4 m
  for (int i = 0; i < 10; ++i) go(i < 5 ? 1.0 : -1.0);  // five metres, and back
  loseAndGo(2.0);                                       // 4 m
  EXPECT_TRUE(isWithinReach(7.9));
  EXPECT_FALSE(isWithinReach(8.1)) << "ten seconds of tracking are no time to go where one likes";
}

TEST_F(ReachTest, AStretchInBetweenLeadsNoLessFarThanItLed) {
  go(0.0);
  loseAndGo(2.0);                        // 4 m
  for (int i = 0; i < 10; ++i) go(2.0);  // twenty metres straight on
  loseAndGo(2.0);                        // 4 m
  EXPECT_TRUE(isWithinReach(12.1));
  EXPECT_FALSE(isWithinReach(11.9));
  EXPECT_FALSE(isWithinReach(0.0)) << "where it began is one room, and this is another that looks the same";
}

TEST_F(ReachTest, WentUnseenAnywhereAtTheSpeedThatItIsSeenToGoWith) {
  go(0.0);
  loseAndGo(4.0);
  EXPECT_NEAR(ambiguity_m(-9.0), 6.0, 1e-9) << "it stood: 1 m and 0.5 m/s, to all sides";
  go(0.6);
  EXPECT_NEAR(ambiguity_m(-9.0), 9.2, 1e-9) << "half as fast again as 0.6 m/s";
  go(0.3, 0.1);
  EXPECT_NEAR(ambiguity_m(-9.0), 9.2, 1e-9) << "so short a step tells of noise";
  go(2.0);
  EXPECT_NEAR(ambiguity_m(-9.0), 14.0, 1e-9) << "max_speed_mps";
}

TEST_F(ReachTest, WhoGoesOnAsBeforeOrStopsIsNearTheStraightWayOn) {
  go(0.0);
  go(0.5);
  loseAndGo(4.0);  // 2 m, had it gone on
  EXPECT_NEAR(ambiguity_m(2.5), 4.0, 1e-9) << "twice the margin besides";
  EXPECT_NEAR(ambiguity_m(0.5), 4.0, 1e-9) << "it stopped";
  EXPECT_NEAR(ambiguity_m(3.49), 4.0, 1e-9);
  EXPECT_NEAR(ambiguity_m(3.51), 8.0, 1e-9) << "1 m and 0.75 m/s to all sides";
  EXPECT_NEAR(ambiguity_m(-0.51), 8.0, 1e-9) << "it turned round";
}

TEST_F(ReachTest, OfTwoGapsNobodyKnowsTheWay) {
  go(0.0);
  go(0.5);
  loseAndGo(4.0);
  loseAndGo(2.0);
  EXPECT_NEAR(ambiguity_m(2.5), 2 * (2.0 + 6.0 * 0.75), 1e-9) << "what it tracked in between is no gap";
}

TEST_F(ReachTest, AsksOnlyThisRun) {
  auto earlier = std::make_shared<odometry::Keyframe>();
  earlier->id = 1;
  earlier->submap = 1;
  earlier->stamp_s = 1700000000.0;
  graph_.restore(earlier, {});
  loseAndGo(1.0);
  EXPECT_TRUE(isWithinReach(100.0)) << "nobody knows what happened in between";
  EXPECT_FALSE(graph::ambiguity_m(graph_, Loop{1, 2, Eigen::Isometry3d::Identity(), 100, {}, {1}}, options_))
      << "nor how far that led";
}

}  // namespace
}  // namespace wardslam::graph
