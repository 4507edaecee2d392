#include "wardslam/graph/saved_graph.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "graph/mapper_walk.h"
#include "graph/synthetic_walk.h"

namespace wardslam::graph {
namespace {

TEST(SavedGraph, KeepsKeyframesAndPointsWhereTheGraphHasThem) {
  test::SyntheticWalk walk;
  KeyframeGraph graph;
  for (const auto& keyframe : walk.walk(3)) graph.insert(keyframe);
  const PointId point = graph.keyframes().at(1).keypointOf.begin()->first;
  graph.setPosition(point, {7, 8, 9});
  graph.setPose(2, test::makePose({1, 2, 3}));
  graph.removeSighting(3, graph.keyframes().at(3).keypointOf.begin()->first);

  const SavedGraph saved = save(graph);
  ASSERT_EQ(saved.keyframes.size(), 3U);
  EXPECT_EQ(saved.p_map_m.size(), graph.points().size());
  EXPECT_EQ(saved.p_map_m.at(point), Eigen::Vector3d(7, 8, 9));
  EXPECT_TRUE(saved.keyframes[1]->T_map_cam.isApprox(test::makePose({1, 2, 3})));
  for (const auto& keyframe : saved.keyframes) {
    EXPECT_EQ(keyframe->submap, saved.map);
    EXPECT_EQ(keyframe->sightings.size(), graph.keyframes().at(keyframe->id).keypointOf.size());
  }
}

TEST(SavedGraph, KeepsPiecesApart) {
  test::SyntheticWalk walk;
  KeyframeGraph graph;
  for (const auto& keyframe : walk.walk(2)) graph.insert(keyframe);
  walk.loseTrack();
  for (const auto& keyframe : walk.walk(3)) graph.insert(keyframe);
  const SavedGraph saved = save(graph);
  ASSERT_EQ(saved.keyframes.size(), 5U);
  EXPECT_EQ(saved.keyframes[0]->submap, 1U);
  EXPECT_EQ(saved.keyframes[4]->submap, 2U);
  EXPECT_EQ(saved.map, 2U) << "the larger";
  EXPECT_EQ(saved.freeSubmap, 3U);
  EXPECT_TRUE(save(KeyframeGraph{}).keyframes.empty());
}

/// A run that goes on in the map of an earlier one.
class GoingOnTest : public MapperWalk {
 protected:
  static constexpr int kMostOfARound = kRound - 8;  // the end does not see what the beginning saw
  static constexpr int kBack = 8;

  void mapMostOfARound(const Eigen::Isometry3d& slip = Eigen::Isometry3d::Identity()) {
    Mapper earlier(fewAndFast(), {});
    for (int i = 0; i < kMostOfARound; ++i) {
      const bool slips = i == kMostOfARound / 2 && !slip.isApprox(Eigen::Isometry3d::Identity());
      if (slips) walk_.forgetPoints();
      insert(earlier, walk_.step(slips ? slip : Eigen::Isometry3d::Identity()));
    }
    ASSERT_TRUE(earlier.loops().empty());
    keep(earlier);
  }

  void keep(const Mapper& earlier) {
    saved_ = save(earlier.graph());
    saved_.loops = earlier.loops();
    mapper_ = std::make_unique<Mapper>(options_, odometry::OdometryOptions{});
    mapper_->restore(saved_);
    walk_.loseTrack();  // the robot was switched off, and begins where it stood
  }

  void goBack() {
    for (int step = 0; step < kBack; ++step) walk_.stepBack();
  }

  /// It begins some way back, goes on to where the earlier run ended, and to where that began.
  void comeRound() {
    goBack();
    goOn(kBack + 16);
    ASSERT_EQ(mapper_->submapsJoined(), 1U);
  }

  void goOn(int keyframes) {
    for (int i = 0; i < keyframes; ++i) {
      for (const auto& removed : mapper_->insert(walk_.step()).removedKeyframes) removed_.insert(removed.id);
    }
    mapper_->adjustAll();
  }

  /// Keyframes that are there still, and that is most of them, and points that only these keyframes see, far away from
  /// where this run went.
  void expectAsSaved(KeyframeId first, KeyframeId last) const {
    const KeyframeGraph& graph = mapper_->graph();
    for (const auto& keyframe : saved_.keyframes) {
      if (removed_.count(keyframe->id) != 0) continue;
      ASSERT_EQ(graph.keyframes().count(keyframe->id), 1U) << keyframe->id;
      EXPECT_EQ(graph.keyframes().at(keyframe->id).T_map_cam.matrix(), keyframe->T_map_cam.matrix()) << keyframe->id;
    }
    EXPECT_LT(removed_.size(), saved_.keyframes.size() / 4);
    std::size_t untouched = 0;
    for (const auto& [id, node] : graph.points()) {
      if (*node.seenBy.begin() < first || *node.seenBy.rbegin() > last) continue;
      ++untouched;
      EXPECT_EQ(node.point.p_map_m, saved_.p_map_m.at(id)) << id;
    }
    EXPECT_GT(untouched, 20U);
  }

  SavedGraph saved_;
  GraphOptions options_ = fewAndFast();
  std::unique_ptr<Mapper> mapper_;
  std::set<KeyframeId> removed_;
};

TEST_F(GoingOnTest, WhatIsSettledStaysToTheLastBitAndWhatComesIsFittedToIt) {
  Mapper earlier(fewAndFast(), {});
  walk(earlier, Eigen::Isometry3d::Identity());
  keep(earlier);
  goOn(12);
  EXPECT_EQ(mapper_->submapsJoined(), 1U);
  expectAsSaved(24, 33);
  for (const auto& [id, node] : mapper_->graph().keyframes()) EXPECT_LT(error_m(*mapper_, id), 0.03) << id;
}

TEST_F(GoingOnTest, ALoopThatTheNewWayExplainsLeavesWhatIsSettled) {
  mapMostOfARound();
  comeRound();
  EXPECT_GE(mapper_->loopsClosed(), 2U) << "one of them the join";
  expectAsSaved(10, 16);
  for (const auto& [id, node] : mapper_->graph().keyframes()) EXPECT_LT(error_m(*mapper_, id), 0.03) << id;
}

TEST_F(GoingOnTest, ALoopThatItDoesNotExplainBendsWhatIsSettled) {
  mapMostOfARound(test::makePose({0.15, 0.05, 0.12}, {0.0, 0.05, 0.0}));
  comeRound();
  for (const auto& [id, node] : mapper_->graph().keyframes()) {
    EXPECT_LT(error_m(*mapper_, id), 0.03) << id << " was off by up to 0.2 m";
    EXPECT_FALSE(node.isSettled) << id;
  }
}

TEST_F(GoingOnTest, ALoopThatIsTakenBackLeavesAllSettled) {
  options_.loop_confirmation.max_misfit_m = 1e-9;  // nothing fits
  mapMostOfARound();
  goBack();
  goOn(6);
  ASSERT_GE(mapper_->loopsTakenBack(), 1U);
  EXPECT_TRUE(mapper_->graph().isAnySettled(saved_.map));
  expectAsSaved(10, 16);
}

}  // namespace
}  // namespace wardslam::graph
