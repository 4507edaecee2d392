#include "movable_judge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "change/depth_scene.h"
#include "filters/ward_fixture.h"

namespace wardslam::filters {
namespace {

using change::test::kFrameTime_s;
using change::test::poseAt;
using Eigen::Vector3d;
using ward::kChair;
using ward::kDog;
using ward::kPerson;
using Finding = Verdict::Finding;

/// A person within 0.4 m of a chair moves it with some probability.
knowledge::MotionRules rulesWithStrength(const std::string& strength) {
  return {knowledge::KnowledgeGraph::fromConfig(
              core::ConfigNode::fromText("entities: {man: [person], dog: [dog], chair: [chair], bed: [bed]}\n"
                                         "sets: {moving: [man, dog], movable: [chair], static: [bed]}\n"
                                         "relations: [can_be_moved_by]\n"
                                         "facts: [[chair, can_be_moved_by, man, {strength: " +
                                         strength + ", reach: 0.4}]]\n")),
          core::LabelSpace::coco()};
}

class MovableJudgeTest : public testing::Test {
 protected:
  /// A person 1.5 m away, and a chair with so much between the two.
  void stand(double gap_m, core::ClassId who = kPerson) {
    scene_.add({1, who, {-0.5, 0.0, 1.5}, 0.4, 1.2});
    scene_.add({2, kChair, {-0.3 + gap_m + 0.25, 0.0, 1.5}, 0.5, 0.5});
  }

  [[nodiscard]] static cv::Mat moversOf(const core::Frame& frame) {
    cv::Mat movers = frame.segmentation.classIds.clone();
    movers.setTo(0, (movers != kPerson) & (movers != kDog));
    return movers;
  }

  Verdict judge(const MovableJudge& judge) {
    const core::Frame frame = scene_.frame(time_s_);
    const auto verdicts = judge.judge(frame, moversOf(frame));
    EXPECT_EQ(verdicts.size(), 1U);
    EXPECT_EQ(verdicts.at(0).instance.id, 2);
    return verdicts.at(0);
  }

  /// So many images of a chair and a person at these speeds (m/s); then the verdict on the chair.
  Verdict watch(MovableJudge& judge, int images, const Vector3d& chair, const Vector3d& person) {
    for (int i = 0; i < images; ++i) {
      judge.observe(scene_.frame(time_s_), poseAt(Vector3d::Zero()));
      time_s_ += kFrameTime_s;
      scene_.thing(0).p_map_m += person * kFrameTime_s;
      scene_.thing(1).p_map_m += chair * kFrameTime_s;
    }
    return this->judge(judge);
  }

  const Vector3d rest_ = Vector3d::Zero();
  const Vector3d walk_{0.4, 0, 0};
  change::test::DepthScene scene_;
  double time_s_ = 0.0;
};

TEST_F(MovableJudgeTest, AThingWithinReachIsSuspectedAtFirst) {
  stand(0.2);
  const auto rules = rulesWithStrength("0.6");
  const Verdict verdict = judge(MovableJudge(rules, {}));
  EXPECT_NEAR(verdict.prior, std::log(0.6 / 0.4), 1e-9);
  EXPECT_EQ(verdict.evidence, 0.0);
  EXPECT_EQ(verdict.finding, Finding::Suspected);
}

TEST_F(MovableJudgeTest, HowMuchItIsSuspectedTheGraphSays) {
  stand(0.2);
  const auto rules = rulesWithStrength("0.2");
  EXPECT_EQ(judge(MovableJudge(rules, {})).finding, Finding::Rests) << "below the 0.3 that count";
  EXPECT_EQ(judge(MovableJudge(rules, {0.1})).finding, Finding::Suspected);
}

TEST_F(MovableJudgeTest, OutOfReachItIsNotSuspected) {
  stand(0.5);
  const auto rules = rulesWithStrength("0.9");
  const Verdict verdict = judge(MovableJudge(rules, {}));
  EXPECT_LT(verdict.prior, -3.0);
  EXPECT_EQ(verdict.finding, Finding::Rests);
}

TEST_F(MovableJudgeTest, WhoCannotMoveItDoesNotMakeItSuspect) {
  stand(0.1, kDog);
  const auto rules = rulesWithStrength("0.9");
  EXPECT_EQ(judge(MovableJudge(rules, {})).finding, Finding::Rests);
}

TEST_F(MovableJudgeTest, NearInTheImageIsNotNearInTheRoom) {
  stand(0.05);
  scene_.thing(1).p_map_m = {0.05, 0.0, 2.2};  // beside him in the image, 0.7 m behind
  const auto rules = rulesWithStrength("0.9");
  EXPECT_EQ(judge(MovableJudge(rules, {})).finding, Finding::Rests);
}

TEST_F(MovableJudgeTest, WithoutDepthItIsTakenToBeWithinReach) {
  stand(0.5);
  const auto rules = rulesWithStrength("0.6");
  core::Frame blind = scene_.frame(0.0);
  blind.depth_m.setTo(0.0);
  const auto verdicts = MovableJudge(rules, {}).judge(blind, moversOf(blind));
  ASSERT_EQ(verdicts.size(), 1U);
  EXPECT_EQ(verdicts[0].finding, Finding::Suspected);
}

TEST_F(MovableJudgeTest, AChairThatDoesNotMoveSoonRestsBesideAPersonWhoDoes) {
  stand(0.1);
  const auto rules = rulesWithStrength("0.6");
  MovableJudge judge(rules, {});
  EXPECT_EQ(watch(judge, 20, rest_, {0, 0.1, 0}).finding, Finding::Rests);
}

TEST_F(MovableJudgeTest, AChairThatIsCarriedMoves) {
  stand(0.1);
  const auto rules = rulesWithStrength("0.2");
  MovableJudge judge(rules, {});
  EXPECT_EQ(watch(judge, 15, walk_, walk_).finding, Finding::Moves) << "though hardly suspected";
}

TEST_F(MovableJudgeTest, AChairThatRollsAloneMoves) {
  stand(1.0);
  const auto rules = rulesWithStrength("0.6");
  MovableJudge judge(rules, {});
  EXPECT_EQ(watch(judge, 15, {0, 0, 0.5}, rest_).finding, Finding::Moves);
}

TEST_F(MovableJudgeTest, SetDownItRestsAfterAWhile) {
  stand(0.1);
  const auto rules = rulesWithStrength("0.6");
  MovableJudge judge(rules, {});
  EXPECT_EQ(watch(judge, 15, walk_, walk_).finding, Finding::Moves);
  EXPECT_EQ(watch(judge, 3, rest_, rest_).finding, Finding::Moves) << "just now";
  EXPECT_EQ(watch(judge, 40, rest_, {0, 0.1, 0}).finding, Finding::Rests);
}

TEST_F(MovableJudgeTest, WhileTheCameraIsLostNothingIsLearnt) {
  stand(0.1);
  const auto rules = rulesWithStrength("0.6");
  MovableJudge judge(rules, {});
  for (int i = 0; i < 30; ++i) judge.observe(scene_.frame(i * kFrameTime_s), std::nullopt);
  EXPECT_EQ(this->judge(judge).finding, Finding::Suspected);
}

}  // namespace
}  // namespace wardslam::filters
