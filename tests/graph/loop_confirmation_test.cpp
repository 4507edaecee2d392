#include "loop_confirmation.h"

#include <gmock/gmock.h>

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

TEST_F(LoopConfirmationTest, SaysWhereToLookNext) {
  confirmation_ = LoopConfirmation(options_);
  EXPECT_THAT(confirmation_.expected(graph_, 15), IsEmpty());
  see(15, {loop(1, 15)});
  EXPECT_THAT(confirmation_.expected(graph_, 18), testing::ElementsAre(4));
}

}  // namespace
}  // namespace wardslam::graph
