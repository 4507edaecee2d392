#include "loop_fit.h"

#include <gtest/gtest.h>

#include "graph/hand_made_keyframe.h"
#include "graph/synthetic_walk.h"

namespace wardslam::graph {
namespace {

using test::makePose;

/// Keyframes 1 to 5 along x, a metre apart, all of which see the same; off by 0.15 m is too much.
class LoopFitTest : public ::testing::Test {
 protected:
  LoopFitTest() {
    for (KeyframeId id = 1; id <= 5; ++id) add(id, 1);
    options_.max_misfit_m = 0.15;
    options_.max_misfit_rad = 0.05;
  }

  void add(KeyframeId id, std::uint32_t piece) {
    auto keyframe = test::handMadeKeyframe(id, {7, 8, 9}, piece);
    if (id > 1) keyframe->T_previous_cam = makePose({1, 0, 0});
    graph_.insert(keyframe);
  }
  static Loop loop(KeyframeId older, KeyframeId newer, double off_m, double off_rad = 0.0) {
    const double way_m = static_cast<double>(newer - older);
    return {older, newer, makePose({way_m + off_m, 0, 0}, {0, 0, off_rad}), 100, {}, {older}};
  }
  [[nodiscard]] bool fits(const Held& before, const std::vector<Loop>& loops) const {
    return fit(graph_, before, loops, options_);
  }
  [[nodiscard]] Held now(const std::vector<Loop>& closed = {}) const {
    return {tiedSteps(graph_, 1, 2), misfitsOf(graph_, closed)};
  }

  KeyframeGraph graph_;
  LoopConfirmationOptions options_;
};

TEST_F(LoopFitTest, OfALoopTellsHowFarTheKeyframesAreFromIt) {
  const auto misfits = misfitsOf(graph_, {loop(1, 4, 0.2), loop(2, 3, 0.0, 0.1)});
  ASSERT_EQ(misfits.size(), 2U);
  EXPECT_NEAR(misfits[0].position_m, 0.2, 1e-12);
  EXPECT_NEAR(misfits[0].rotation_rad, 0.0, 1e-7);
  EXPECT_NEAR(misfits[1].position_m, 0.0, 1e-12);
  EXPECT_NEAR(misfits[1].rotation_rad, 0.1, 1e-7);
}

TEST_F(LoopFitTest, OfALoopBetweenPiecesNothingIsKnown) {
  add(6, 2);
  EXPECT_EQ(misfitsOf(graph_, {loop(1, 6, 3.0)}).front().position_m, 0.0);
}

TEST_F(LoopFitTest, ANewLoopMustHold) {
  EXPECT_TRUE(fits(now(), {loop(1, 4, 0.14)}));
  EXPECT_FALSE(fits(now(), {loop(1, 4, 0.16)}));
  EXPECT_TRUE(fits(now(), {loop(1, 4, 0.0, 0.04)}));
  EXPECT_FALSE(fits(now(), {loop(1, 4, 0.0, 0.06)}));
}

/// A look from afar that was believed, and is off by a little more by now: no other loop is wrong for that.
TEST_F(LoopFitTest, WhatAnOlderLoopWasOffByBeforeTellsNothing) {
  const Loop old = loop(1, 4, 0.2, 0.1);
  EXPECT_TRUE(fits(now({old}), {old, loop(2, 5, 0.0)}));
  EXPECT_FALSE(fits(now({old}), {old, loop(2, 5, 0.2)})) << "but what the new one is off by does";
}

TEST_F(LoopFitTest, AnOlderLoopMustNotComeToBeOffByMore) {
  const Loop old = loop(1, 4, 0.12);
  const Held before = now({old});
  graph_.setPose(4, makePose({2.98, 0, 0}));
  EXPECT_TRUE(fits(before, {old})) << "0.14 m";
  graph_.setPose(4, makePose({2.96, 0, 0}));
  EXPECT_FALSE(fits(before, {old})) << "0.16 m, 0.04 m of which are new";
  graph_.setPose(4, makePose({3.04, 0, 0}));
  EXPECT_TRUE(fits(before, {old})) << "nearer than before";
}

TEST_F(LoopFitTest, StepsBetweenKeyframesThatSeeTheSameMustHold) {
  const Held before = now();
  EXPECT_EQ(before.steps.size(), 4U);
  graph_.setPose(5, makePose({4.14, 0, 0}));
  EXPECT_TRUE(fits(before, {}));
  graph_.setPose(5, makePose({4.16, 0, 0}));
  EXPECT_FALSE(fits(before, {}));
}

TEST_F(LoopFitTest, AStepWithLittleInCommonTellsNothing) { EXPECT_TRUE(tiedSteps(graph_, 1, 4).empty()); }

}  // namespace
}  // namespace wardslam::graph
