#include "lookalikes.h"

#include <gtest/gtest.h>

#include <limits>

#include "graph/hand_made_keyframe.h"
#include "graph/synthetic_walk.h"

namespace wardslam::graph {
namespace {

/// Keyframes 1 to 4 of one piece and 5 of another, all where their map begins.
class LookalikesTest : public ::testing::Test {
 protected:
  LookalikesTest() {
    for (KeyframeId id = 1; id <= 5; ++id) graph_.insert(test::handMadeKeyframe(id, {}, id < 5 ? 1 : 2));
  }

  static Loop loop(KeyframeId older, KeyframeId newer, double off_m) {
    return {older, newer, test::makePose({off_m, 0, 0}), 100, {}, {older}};
  }

  KeyframeGraph graph_;
  Lookalikes lookalikes_;
};

TEST_F(LookalikesTest, BelievesWhatHasNoDouble) {
  lookalikes_.add(loop(1, 3, 6.0), {3}, 6.0);
  EXPECT_FALSE(lookalikes_.areMistakable(graph_, loop(2, 4, 5.0)));
  EXPECT_FALSE(lookalikes_.areMistakable(graph_, loop(2, 5, 5.0)));
}

TEST_F(LookalikesTest, BelievesALoopThatIsNearerThanTheDouble) {
  lookalikes_.add(loop(1, 3, 6.0), {3}, 6.0);
  EXPECT_FALSE(lookalikes_.areMistakable(graph_, loop(1, 4, 2.9)));
  EXPECT_TRUE(lookalikes_.areMistakable(graph_, loop(1, 4, 3.1)));
}

TEST_F(LookalikesTest, BelievesNoJoinAtAPlaceThatHasADouble) {
  lookalikes_.add(loop(1, 3, 6.0), {3}, 6.0);
  EXPECT_TRUE(lookalikes_.areMistakable(graph_, loop(1, 5, 0.0)));
  EXPECT_TRUE(lookalikes_.areMistakable(graph_, loop(3, 5, 0.0))) << "nor at the double";
}

TEST_F(LookalikesTest, KnowsNotHowFarADoubleOfAnotherPieceIs) {
  lookalikes_.add(loop(1, 5, 0.0), {5}, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(lookalikes_.areMistakable(graph_, loop(1, 4, 3.0)));
  EXPECT_TRUE(lookalikes_.areMistakable(graph_, loop(1, 5, 0.0)));
}

TEST_F(LookalikesTest, WhatSeesTheSameHasTheSameDouble) {
  lookalikes_.add(loop(1, 5, 0.0), {5, 4}, std::numeric_limits<double>::infinity());
  const Loop atNewer = loop(4, 5, 0.0);
  EXPECT_TRUE(lookalikes_.areMistakable(graph_, atNewer));
  EXPECT_TRUE(lookalikes_.areMistakable(graph_, loop(2, 5, 0.0))) << "also where the older has no double that is known";
}

TEST_F(LookalikesTest, FollowsWhatIsGivenUp) {
  lookalikes_.add(loop(1, 3, 6.0), {3}, 6.0);
  odometry::RemovedKeyframe removed;
  removed.id = 1;
  removed.heir = 2;
  lookalikes_.apply(removed);
  EXPECT_TRUE(lookalikes_.areMistakable(graph_, loop(2, 5, 0.0)));
}

}  // namespace
}  // namespace wardslam::graph
