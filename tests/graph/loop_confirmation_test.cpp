#include "loop_confirmation.h"

#include <gmock/gmock.h>

#include <set>

#include "graph/synthetic_walk.h"

namespace wardslam::graph {
namespace {

using test::makePose;
using testing::IsEmpty;
using testing::SizeIs;

/// Keyframes 1 to 20 along x, a metre apart; loops say that the last ones stand where the first ones do, or elsewhere.
class LoopConfirmationTest : public ::testing::Test {
 protected:
  LoopConfirmationTest() {
    for (KeyframeId id = 1; id <= 20; ++id) {
      auto keyframe = std::make_shared<odometry::Keyframe>();
      keyframe->id = id;
      keyframe->submap = 1;
      if (id > 1) keyframe->T_previous_cam = makePose({1, 0, 0});
      graph_.insert(keyframe);
    }
    options_.keyframes = 3;
    options_.max_gap = 2;
  }

  /// That `newer` stands `off_m` beside `older`.
  static Loop loop(KeyframeId older, KeyframeId newer, double off_m = 0.0) {
    return {older, newer, makePose({0, off_m, 0}), 100, {}, {older}};
  }
  std::vector<Loop> see(KeyframeId newest, const std::vector<Loop>& seen) {
    return confirmation_.confirm(graph_, newest, seen);
  }

  LoopConfirmationOptions options_;
  KeyframeGraph graph_;
  LoopConfirmation confirmation_{LoopConfirmationOptions{}};
};

TEST_F(LoopConfirmationTest, AsksForSeveralThatAgree) {
  confirmation_ = LoopConfirmation(options_);
  EXPECT_THAT(see(15, {loop(1, 15)}), IsEmpty());
  EXPECT_THAT(see(16, {loop(2, 16, 0.1)}), IsEmpty());
  const auto confirmed = see(17, {loop(3, 17)});
  ASSERT_THAT(confirmed, SizeIs(3));
  EXPECT_EQ(confirmed.front().newer, 17U) << "the newest first";
  EXPECT_THAT(see(18, {loop(4, 18)}), IsEmpty()) << "it begins anew";
}

TEST_F(LoopConfirmationTest, DoesNotCountThoseThatSaySomethingElse) {
  confirmation_ = LoopConfirmation(options_);
  see(15, {loop(1, 15)});
  see(16, {loop(2, 16, 0.8)});
  EXPECT_THAT(see(17, {loop(3, 17)}), IsEmpty());
}

TEST_F(LoopConfirmationTest, NorThoseThatSayItIsTurned) {
  confirmation_ = LoopConfirmation(options_);
  see(15, {loop(1, 15)});
  see(16, {loop(2, 16)});
  Loop turned = loop(3, 17);
  turned.T_older_newer.rotate(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()));
  EXPECT_THAT(see(17, {turned}), IsEmpty());
}

/// Places 1 to 3, a metre apart, all of which say that 15 stands at the first.
TEST_F(LoopConfirmationTest, CountsAKeyframeOnceAsTheBestPlaceKnowsIt) {
  confirmation_ = LoopConfirmation(options_);
  Loop best{2, 15, makePose({-1, 0, 0}), 150, {}, {2}};
  EXPECT_THAT(see(15, {loop(1, 15), best, {3, 15, makePose({-2, 0, 0}), 120, {}, {3}}}), IsEmpty());
  see(16, {loop(2, 16)});
  const auto confirmed = see(17, {loop(3, 17)});
  ASSERT_THAT(confirmed, SizeIs(3));
  EXPECT_EQ(confirmed.back().inliers, 150);
}

TEST_F(LoopConfirmationTest, WhatIsGivenUpLeavesItsLookToItsHeir) {
  confirmation_ = LoopConfirmation(options_);
  see(15, {loop(1, 15)});
  see(16, {loop(2, 16)});
  confirmation_.apply({16, 15, makePose({1, 0, 0})});
  confirmation_.apply({2, 3, makePose({-1, 0, 0})});
  graph_.remove(16);
  graph_.remove(2);
  const auto confirmed = see(17, {loop(3, 17)});
  ASSERT_THAT(confirmed, SizeIs(3));
  EXPECT_EQ(confirmed[1].older, 3U);
  EXPECT_EQ(confirmed[1].newer, 15U);
  EXPECT_TRUE(confirmed[1].T_older_newer.isApprox(makePose({-2, 0, 0}))) << "where 1 is";
}

TEST_F(LoopConfirmationTest, ForgetsWhatIsNotSeenAgainSoon) {
  confirmation_ = LoopConfirmation(options_);
  see(12, {loop(1, 12)});
  see(13, {loop(2, 13)});
  for (const KeyframeId newest : {14, 15, 16}) EXPECT_THAT(see(newest, {}), IsEmpty());
  EXPECT_THAT(see(17, {loop(6, 17)}), IsEmpty());
}

TEST_F(LoopConfirmationTest, WaitsWhileAnotherPlaceLooksTheSame) {
  confirmation_ = LoopConfirmation(options_);
  for (const KeyframeId newest : {15, 16, 17}) {
    EXPECT_THAT(see(newest, {loop(newest - 14, newest), loop(newest - 10, newest)}), IsEmpty());
  }
  EXPECT_THAT(see(18, {loop(4, 18)}), IsEmpty());
  EXPECT_THAT(see(19, {loop(5, 19)}), IsEmpty());
  EXPECT_THAT(see(20, {loop(6, 20)}), SizeIs(6)) << "the other has not been seen for long";
}

/// Keyframes from 15 on are of another piece.
class JoinConfirmationTest : public LoopConfirmationTest {
 protected:
  JoinConfirmationTest() {
    graph_ = KeyframeGraph();
    for (KeyframeId id = 1; id <= 20; ++id) {
      auto keyframe = std::make_shared<odometry::Keyframe>();
      keyframe->id = id;
      keyframe->submap = id < 15 ? 1 : 2;
      if (id != 1 && id != 15) keyframe->T_previous_cam = makePose({1, 0, 0});
      graph_.insert(keyframe);
    }
    options_.keyframes = 2;
    options_.keyframes_to_join = 3;
    confirmation_ = LoopConfirmation(options_);
  }

  static Loop strongLoop(KeyframeId older, KeyframeId newer) {
    Loop strong = loop(older, newer);
    strong.spread = 0.75;
    strong.depth.agreeing = 2000;
    strong.depth.unknown = 1000;
    return strong;
  }
  std::vector<Loop> settle() {
    return confirmation_.settle(graph_, [this](const Loop& loop) { return refused_.count(loop.newer) != 0; });
  }

  std::set<KeyframeId> refused_;
};

TEST_F(JoinConfirmationTest, AsksForMoreThanALoop) {
  EXPECT_THAT(see(15, {loop(1, 15)}), IsEmpty());
  EXPECT_THAT(see(16, {loop(2, 16)}), IsEmpty());
  EXPECT_THAT(see(17, {loop(3, 17)}), SizeIs(3));
}

TEST_F(JoinConfirmationTest, TakesOneStrongLook) { EXPECT_THAT(see(15, {strongLoop(1, 15)}), SizeIs(1)); }

TEST_F(JoinConfirmationTest, AStrongLookIsManyPointsAllOverTheImageBorneOutByDepth) {
  EXPECT_TRUE(confirmation_.isStrong(strongLoop(1, 15)));
  Loop weak = strongLoop(1, 15);
  weak.inliers = 79;
  EXPECT_FALSE(confirmation_.isStrong(weak));
  weak = strongLoop(1, 15);
  weak.spread = 0.4;
  EXPECT_FALSE(confirmation_.isStrong(weak)) << "one poster";
  weak = strongLoop(1, 15);
  weak.depth.seenThrough = 150;
  EXPECT_FALSE(confirmation_.isStrong(weak));
  weak = strongLoop(1, 15);
  weak.depth = {};
  EXPECT_FALSE(confirmation_.isStrong(weak)) << "of which depth says nothing";
}

TEST_F(JoinConfirmationTest, OneOfTwoPlacesThatLookAlikeIsNotChosen) {
  EXPECT_THAT(see(15, {strongLoop(1, 15), strongLoop(8, 15)}), IsEmpty());
  EXPECT_THAT(see(20, {}), IsEmpty()) << "by now both are forgotten, for now";
  EXPECT_THAT(see(20, {strongLoop(6, 20)}), IsEmpty()) << "the other still speaks against it";
  EXPECT_THAT(settle(), IsEmpty());
}

TEST_F(JoinConfirmationTest, ThePlaceSeenLessExactlyFromAfarIsNoRival) {
  EXPECT_THAT(see(15, {loop(1, 15, 0.4)}), IsEmpty());
  EXPECT_THAT(see(20, {strongLoop(6, 20)}), SizeIs(1));
}

TEST_F(JoinConfirmationTest, APlaceAMetreBesideItIs) {
  EXPECT_THAT(see(15, {loop(1, 15, 1.0)}), IsEmpty());
  EXPECT_THAT(see(20, {strongLoop(6, 20)}), IsEmpty());
}

TEST_F(LoopConfirmationTest, ThePlaceSeenLessExactlyIsNoRivalOfALoopEither) {
  confirmation_ = LoopConfirmation(options_);
  EXPECT_THAT(see(15, {loop(1, 15), loop(1, 15, 0.4)}), IsEmpty());
  EXPECT_THAT(see(16, {loop(2, 16), loop(2, 16, 0.4)}), IsEmpty());
  EXPECT_THAT(see(17, {loop(3, 17)}), SizeIs(3));
}

/// As above, with a second between keyframes and `unseen_s` before the other piece.
KeyframeGraph lostFor(double unseen_s) {
  KeyframeGraph lost;
  for (KeyframeId id = 1; id <= 28; ++id) {
    auto keyframe = std::make_shared<odometry::Keyframe>();
    keyframe->id = id;
    keyframe->submap = id < 15 ? 1 : 2;
    keyframe->stamp_s = static_cast<double>(id) + (id < 15 ? 0.0 : unseen_s - 1.0);
    if (id != 1 && id != 15) keyframe->T_previous_cam = makePose({1, 0, 0});
    lost.insert(keyframe);
  }
  return lost;
}

TEST_F(JoinConfirmationTest, AfterItWentFarUnseenOneRoomIsNotEnough) {
  const KeyframeGraph lost = lostFor(11.0);
  for (KeyframeId newest = 15; newest <= 23; ++newest) {
    EXPECT_THAT(confirmation_.confirm(lost, newest, {strongLoop(newest - 14, newest)}), IsEmpty()) << newest;
  }
  EXPECT_THAT(confirmation_.confirm(lost, 24, {strongLoop(10, 24)}), SizeIs(10)) << "nine metres on";
}

/// A metre and 3 s at 1.5 m/s, to either side: 11 m.
TEST_F(JoinConfirmationTest, AfterAFewSecondsUnseenOneLookIsBorneOutAllOverTheImage) {
  const KeyframeGraph lost = lostFor(3.0);
  const Eigen::Isometry3d T_12_15 =  // it turned to the left: half a metre back, and 2.5 m to the side
      Eigen::Translation3d(1.5, 2.5, 0) * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ());
  const auto turned = [&](KeyframeId newer) {
    Loop look = strongLoop(12, newer);
    look.T_older_newer = T_12_15 * makePose({static_cast<double>(newer) - 15.0, 0, 0});
    look.inliers = 40;
    return look;
  };
  for (KeyframeId newest = 15; newest <= 19; ++newest) {
    Loop ofAPart = turned(newest);
    ofAPart.spread = 0.4;
    EXPECT_THAT(confirmation_.confirm(lost, newest, {ofAPart}), IsEmpty()) << newest;
  }
  const Loop allOver = turned(20);
  EXPECT_THAT(confirmation_.confirm(lost, 20, {allOver}), SizeIs(6));
}

/// Six metres back within three seconds, and on as before.
TEST_F(JoinConfirmationTest, WhereOnlySomebodyElseCanHaveCarriedItARoomIsNotEnoughHoweverWellItFits) {
  const KeyframeGraph lost = lostFor(3.0);
  for (KeyframeId newest = 15; newest <= 21; ++newest) {
    EXPECT_THAT(confirmation_.confirm(lost, newest, {strongLoop(newest - 7, newest)}), IsEmpty()) << newest;
  }
}

/// From keyframe 14, which stands at x = 13, it went on at 1 m/s.
TEST_F(JoinConfirmationTest, WhereItWasGoingAFewLooksAreEnough) {
  const KeyframeGraph lost = lostFor(3.0);
  const auto ahead = [](KeyframeId newer) {
    return Loop{14, newer, makePose({static_cast<double>(newer) - 12.0, 0, 0}), 100, {}, {14}};
  };
  EXPECT_THAT(confirmation_.confirm(lost, 15, {ahead(15)}), IsEmpty());
  EXPECT_THAT(confirmation_.confirm(lost, 16, {ahead(16)}), IsEmpty());
  EXPECT_THAT(confirmation_.confirm(lost, 17, {ahead(17)}), SizeIs(3));
}

/// As where it was going, with two places that look alike: seen first in two keyframes, then in three.
class RivalJoinTest : public JoinConfirmationTest {
 protected:
  static Loop ahead(KeyframeId newer, double beside_m = 0.0) {
    return {14, newer, makePose({static_cast<double>(newer) - 12.0, beside_m, 0}), 100, {}, {14}};
  }
  std::vector<Loop> seeAfter(const std::vector<Loop>& rival, KeyframeId last) {
    for (const Loop& loop : rival) confirmation_.confirm(lost_, loop.newer, {loop});
    std::vector<Loop> confirmed;
    for (auto id = rival.back().newer + 1; id <= last; ++id) confirmed = confirmation_.confirm(lost_, id, {ahead(id)});
    return confirmed;
  }

  const KeyframeGraph lost_ = lostFor(3.0);
};

TEST_F(RivalJoinTest, WhereItCanHardlyHaveBeenCarriedIsNone) {
  EXPECT_THAT(seeAfter({strongLoop(8, 15), strongLoop(9, 16)}, 19), SizeIs(3));
}

TEST_F(RivalJoinTest, ButForOneOfWhichAsMuchIsSeen) {
  EXPECT_THAT(seeAfter({strongLoop(8, 15), strongLoop(9, 16), strongLoop(10, 17)}, 20), IsEmpty());
}

TEST_F(RivalJoinTest, WhereItCanHaveGoneIs) { EXPECT_THAT(seeAfter({ahead(15, 1.0), ahead(16, 1.0)}, 19), IsEmpty()); }

TEST_F(JoinConfirmationTest, InTheEndTakesTheBestThereWas) {
  see(15, {loop(1, 15)});
  see(16, {loop(2, 16)});
  EXPECT_THAT(see(20, {}), IsEmpty());
  const auto settled = settle();
  ASSERT_THAT(settled, SizeIs(2));
  EXPECT_EQ(settled.front().newer, 16U) << "the newest first";
  EXPECT_THAT(settle(), IsEmpty()) << "there is no more";
}

/// Of a second piece one look, of a third two.
TEST_F(JoinConfirmationTest, InTheEndTheBestComesFirst) {
  for (const KeyframeId id : {21, 22}) {
    auto keyframe = std::make_shared<odometry::Keyframe>();
    keyframe->id = id;
    keyframe->submap = 3;
    if (id == 22) keyframe->T_previous_cam = makePose({1, 0, 0});
    graph_.insert(keyframe);
  }
  see(15, {loop(1, 15)});
  see(21, {loop(5, 21)});
  EXPECT_THAT(see(22, {loop(6, 22)}), IsEmpty());
  EXPECT_THAT(settle(), SizeIs(2));
  EXPECT_THAT(settle(), SizeIs(1));
}

TEST_F(JoinConfirmationTest, InTheEndARoomIsNotEnoughEither) {
  const KeyframeGraph lost = lostFor(11.0);
  for (KeyframeId newest = 15; newest <= 18; ++newest) {
    EXPECT_THAT(confirmation_.confirm(lost, newest, {strongLoop(newest - 14, newest)}), IsEmpty()) << newest;
  }
  EXPECT_THAT(confirmation_.settle(lost, [](const Loop& /*loop*/) { return false; }), IsEmpty());
}

TEST_F(JoinConfirmationTest, InTheEndLeavesOutWhatIsRefused) {
  see(15, {loop(1, 15)});
  refused_ = {15};
  EXPECT_THAT(settle(), IsEmpty());
}

TEST_F(LoopConfirmationTest, SaysWhereToLookNext) {
  confirmation_ = LoopConfirmation(options_);
  EXPECT_THAT(confirmation_.expected(graph_, 15), IsEmpty());
  see(15, {loop(1, 15)});
  EXPECT_THAT(confirmation_.expected(graph_, 18), testing::ElementsAre(4));
}

}  // namespace
}  // namespace wardslam::graph
