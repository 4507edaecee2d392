#include "wardslam/graph/keyframe_graph.h"

#include <gmock/gmock.h>

#include "graph/hand_made_keyframe.h"
#include "graph/synthetic_walk.h"

namespace wardslam::graph {
namespace {

using test::handMadeKeyframe;
using test::makePose;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;
using testing::UnorderedElementsAre;

TEST(KeyframeGraph, CountsSharedPointsMostFirst) {
  KeyframeGraph graph;
  graph.insert(handMadeKeyframe(1, {1, 2, 3, 4}));
  graph.insert(handMadeKeyframe(2, {4, 5}));
  graph.insert(handMadeKeyframe(3, {2, 3, 4, 5, 6}));
  graph.insert(handMadeKeyframe(4, {7}));
  EXPECT_THAT(graph.covisible(1), ElementsAre(Pair(3, 3), Pair(2, 1)));
  EXPECT_THAT(graph.covisible(2), ElementsAre(Pair(3, 2), Pair(1, 1)));
  EXPECT_THAT(graph.covisible(4), IsEmpty());
}

/// By the points themselves.
std::map<KeyframeId, std::size_t> sharedWith(const KeyframeGraph& graph, KeyframeId id) {
  std::map<KeyframeId, std::size_t> shared;
  for (const auto& [point, node] : graph.points()) {
    if (node.seenBy.count(id) == 0) continue;
    for (const KeyframeId other : node.seenBy) shared[other] += other == id ? 0 : 1;
  }
  shared.erase(id);
  return shared;
}

void expectRightCounts(const KeyframeGraph& graph, const char* when) {
  for (const auto& [id, node] : graph.keyframes()) {
    const auto covisible = graph.covisible(id);
    const std::map<KeyframeId, std::size_t> counted(covisible.begin(), covisible.end());
    EXPECT_EQ(counted, sharedWith(graph, id)) << id << " " << when;
    EXPECT_EQ(covisible.size(), counted.size());
  }
}

TEST(KeyframeGraph, KeepsCountWhateverChanges) {
  KeyframeGraph graph;
  graph.insert(handMadeKeyframe(1, {1, 2, 3, 4}));
  graph.insert(handMadeKeyframe(2, {1, 2, 5, 6}));
  graph.insert(handMadeKeyframe(3, {1, 5, 6, 7}));
  graph.insert(handMadeKeyframe(4, {1, 4, 7, 8}));
  expectRightCounts(graph, "at first");
  EXPECT_THAT(graph.covisible(1), ElementsAre(Pair(2, 2), Pair(4, 2), Pair(3, 1)));
  graph.removeSighting(2, 1);
  expectRightCounts(graph, "with a sighting less");
  EXPECT_THAT(graph.covisible(2), ElementsAre(Pair(3, 2), Pair(1, 1)));
  const auto before = graph.covisible(3);
  graph.beginTrial();
  graph.fuse(7, 1);  // both see it as 1, too
  graph.fuse(5, 4);
  expectRightCounts(graph, "with points that are one");
  EXPECT_NE(graph.covisible(3), before);
  graph.takeBack();
  expectRightCounts(graph, "after a trial");
  EXPECT_EQ(graph.covisible(3), before);
  graph.fuse(5, 4);
  graph.insert(handMadeKeyframe(5, {5, 4, 2}));  // the first two are one
  expectRightCounts(graph, "with a keyframe that knows a point by two names");
  graph.remove(3);
  expectRightCounts(graph, "without a keyframe");
  EXPECT_THAT(graph.covisible(5), ElementsAre(Pair(1, 2), Pair(2, 2), Pair(4, 1)));
}

TEST(KeyframeGraph, PlacesAKeyframeWhereThePreviousIsNow) {
  KeyframeGraph graph;
  graph.insert(handMadeKeyframe(1, {1}));
  graph.setPose(1, makePose({10, 0, 0}));
  auto next = handMadeKeyframe(2, {2});
  next->T_map_cam = makePose({0, 0, 1});  // tracking has not heard of the correction
  next->T_previous_cam = makePose({0, 0, 1});
  graph.insert(next);
  EXPECT_TRUE(graph.keyframes().at(2).T_map_cam.isApprox(makePose({10, 0, 1})));
  const Eigen::Vector3d p_cam_m((20.0 - 319.5) / 525.0 * 2.0, (100.0 - 239.5) / 525.0 * 2.0, 2.0);
  EXPECT_TRUE(graph.points().at(2).point.p_map_m.isApprox(p_cam_m + Eigen::Vector3d(10, 0, 1)));
}

TEST(KeyframeGraph, PlacesAKeyframeAsToldWhereNobodyMeasuredTheWayToIt) {
  KeyframeGraph graph;
  graph.insert(handMadeKeyframe(1, {1}));
  auto next = handMadeKeyframe(2, {2});
  next->T_map_cam = makePose({20, 0, 0});
  graph.insert(next);
  EXPECT_TRUE(graph.keyframes().at(2).T_map_cam.isApprox(makePose({20, 0, 0})));
}

TEST(KeyframeGraph, MakesNoPointWithoutDepth) {
  KeyframeGraph graph;
  graph.insert(handMadeKeyframe(1, {1}));
  auto flat = handMadeKeyframe(2, {1, 2});
  for (auto& keypoint : flat->features.keypoints) keypoint.depth_m = 0.0F;
  graph.insert(flat);
  EXPECT_THAT(graph.keyframes().at(2).keypointOf, ElementsAre(Pair(1, 0))) << "known points need no depth";
  EXPECT_EQ(graph.points().count(2), 0U);
}

TEST(KeyframeGraph, APointOfAnEarlierRunIsSeenWithoutDepthToo) {
  auto flat = handMadeKeyframe(1, {1, 2, 3});
  for (auto& keypoint : flat->features.keypoints) keypoint.depth_m = 0.0F;
  const std::map<PointId, Eigen::Vector3d> p_map_m{{1, {-1.1, -0.5, 2.01}}, {2, {-1.0, -0.5, 2.02}}};
  KeyframeGraph graph;
  graph.restore(flat, p_map_m);
  graph.restore(handMadeKeyframe(2, {1}), p_map_m);
  EXPECT_THAT(graph.keyframes().at(1).keypointOf, ElementsAre(Pair(1, 0), Pair(2, 1)))
      << "nobody knows where the third is";
  EXPECT_THAT(graph.points().at(1).seenBy, ElementsAre(1, 2));
  for (const auto& [id, place_m] : p_map_m) EXPECT_EQ(graph.points().at(id).point.p_map_m, place_m) << id;
  EXPECT_GT(graph.points().at(2).point.information_per_m2.determinant(), 1e9) << "known to centimetres";
  EXPECT_EQ(flat->features.keypoints[0].depth_m, 0.0F);
}

TEST(KeyframeGraph, WhatAnEarlierRunSettledIsSoUntilItsSubmapIsJoinedOrGivesWay) {
  KeyframeGraph graph;
  graph.restore(handMadeKeyframe(1, {1}, 1), {});
  graph.restore(handMadeKeyframe(2, {2}, 2), {});
  graph.insert(handMadeKeyframe(3, {3}, 3));
  const auto areSettled = [&] {
    std::set<KeyframeId> settled;
    for (const auto& [id, node] : graph.keyframes()) {
      if (node.isSettled) settled.insert(id);
    }
    return settled;
  };
  EXPECT_THAT(areSettled(), ElementsAre(1, 2));
  EXPECT_FALSE(graph.isAnySettled(3));
  graph.beginTrial();
  graph.joinSubmaps(2, 1);
  graph.joinSubmaps(3, 1);
  EXPECT_THAT(areSettled(), ElementsAre(1)) << "the frame is that of the first";
  graph.unsettle(1);
  EXPECT_THAT(areSettled(), IsEmpty());
  EXPECT_FALSE(graph.isAnySettled(1));
  graph.takeBack();
  EXPECT_THAT(areSettled(), ElementsAre(1, 2));
  EXPECT_TRUE(graph.isAnySettled(2));
  graph.hold();
  EXPECT_THAT(areSettled(), IsEmpty()) << "held is more";
}

TEST(KeyframeGraph, APointGoesWithItsLastSighting) {
  KeyframeGraph graph;
  graph.insert(handMadeKeyframe(1, {1, 2}));
  graph.insert(handMadeKeyframe(2, {1}));
  graph.removeSighting(1, 1);
  EXPECT_THAT(graph.points().at(1).seenBy, ElementsAre(2));
  EXPECT_THAT(graph.keyframes().at(1).keypointOf, ElementsAre(Pair(2, 1)));
  graph.removeSighting(2, 1);
  EXPECT_EQ(graph.points().count(1), 0U);
  EXPECT_THAT(graph.keyframes().at(2).keypointOf, IsEmpty());
}

TEST(KeyframeGraph, AFusedPointHandsItsSightingsOn) {
  KeyframeGraph graph;
  graph.insert(handMadeKeyframe(1, {1}));
  graph.insert(handMadeKeyframe(2, {9, 2}));
  graph.insert(handMadeKeyframe(3, {1, 2}));
  graph.fuse(2, 1);
  EXPECT_EQ(graph.points().count(2), 0U);
  EXPECT_THAT(graph.points().at(1).seenBy, ElementsAre(1, 2, 3));
  EXPECT_THAT(graph.keyframes().at(2).keypointOf, UnorderedElementsAre(Pair(1, 1), Pair(9, 0)));
  EXPECT_THAT(graph.keyframes().at(3).keypointOf, ElementsAre(Pair(1, 0))) << "it saw both: its own sighting stays";
  EXPECT_THAT(graph.covisible(1), ElementsAre(Pair(2, 1), Pair(3, 1)));
}

TEST(KeyframeGraph, AFusedPointIsKnownByItsOldNameToo) {
  KeyframeGraph graph;
  graph.insert(handMadeKeyframe(1, {1, 2, 3}));
  graph.fuse(3, 2);
  graph.fuse(2, 1);
  graph.insert(handMadeKeyframe(2, {7, 3}));  // tracking has not heard of it
  EXPECT_THAT(graph.keyframes().at(2).keypointOf, UnorderedElementsAre(Pair(1, 1), Pair(7, 0)));
  EXPECT_THAT(graph.points().at(1).seenBy, ElementsAre(1, 2));
  EXPECT_EQ(graph.points().count(3), 0U);
}

TEST(KeyframeGraph, KeyframesOfAJoinedSubmapFollowTheirMap) {
  KeyframeGraph graph;
  graph.insert(handMadeKeyframe(1, {1}, 1));
  graph.insert(handMadeKeyframe(2, {2}, 2));
  graph.insert(handMadeKeyframe(3, {3}, 3));
  EXPECT_EQ(graph.keyframes().at(3).submap, 3U);
  graph.joinSubmaps(3, 2);
  graph.joinSubmaps(2, 1);
  for (const auto& [id, node] : graph.keyframes()) EXPECT_EQ(node.submap, 1U) << id;
  graph.setPose(3, makePose({5, 0, 0}));
  auto late = handMadeKeyframe(4, {4}, 3);
  late->T_previous_cam = makePose({0, 1, 0});
  graph.insert(late);
  EXPECT_EQ(graph.keyframes().at(4).submap, 1U);
  EXPECT_TRUE(graph.keyframes().at(4).T_map_cam.isApprox(makePose({5, 1, 0})));
}

TEST(KeyframeGraph, APointMovesWithThePlaceItWasSeenFrom) {
  KeyframeGraph graph;
  graph.insert(handMadeKeyframe(1, {1}));
  const Eigen::Vector3d before_m = graph.points().at(1).point.p_map_m;
  graph.setPosition(1, before_m + Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE(graph.points().at(1).point.p_map_m.isApprox(before_m + Eigen::Vector3d(1, 2, 3)));
  EXPECT_TRUE(graph.points().at(1).point.viewedFrom_map_m.isApprox(Eigen::Vector3d(1, 2, 3)));
}

TEST(KeyframeGraph, APointThatTurnsIsSeenFromTheSideThatTurnedAlong) {
  KeyframeGraph graph;
  graph.insert(handMadeKeyframe(1, {1}));
  const odometry::MapPoint before = graph.points().at(1).point;
  const Eigen::Isometry3d halfTurn = Eigen::Translation3d(3, 0, 0) * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ());
  graph.movePoint(1, halfTurn);
  const odometry::MapPoint& after = graph.points().at(1).point;
  EXPECT_TRUE(after.p_map_m.isApprox(halfTurn * before.p_map_m));
  EXPECT_TRUE(after.viewedFrom_map_m.isApprox(Eigen::Vector3d(3, 0, 0)));
}

TEST(KeyframeGraph, ARemovedKeyframeTakesAlongWhatOnlyItSaw) {
  KeyframeGraph graph;
  graph.insert(handMadeKeyframe(1, {1, 2, 3}));
  graph.insert(handMadeKeyframe(2, {1}));
  EXPECT_THAT(graph.remove(1), ElementsAre(2, 3));
  EXPECT_EQ(graph.keyframes().count(1), 0U);
  EXPECT_THAT(graph.points().at(1).seenBy, ElementsAre(2));
  EXPECT_EQ(graph.points().size(), 1U);
  EXPECT_THAT(graph.covisible(2), IsEmpty());
}

/// All that a loop does.
void changeAll(KeyframeGraph& graph) {
  graph.joinSubmaps(2, 1);
  graph.setPose(1, makePose({1, 0, 0}));
  graph.setPose(1, makePose({2, 0, 0}));
  graph.setPosition(1, {7, 7, 7});
  graph.setPosition(4, {8, 8, 8});
  graph.fuse(4, 1);
  graph.setPosition(1, {9, 9, 9});
  graph.movePoint(5, makePose({1, 2, 3}) * Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitX()));
  graph.removeSighting(1, 2);
  graph.removeSighting(1, 3);
}

TEST(KeyframeGraph, ATrialIsTakenBackWhole) {
  KeyframeGraph graph;
  graph.insert(handMadeKeyframe(1, {1, 2, 3}));
  graph.insert(handMadeKeyframe(2, {4, 2, 5}, 2));
  const KeyframeGraph before = graph;
  graph.beginTrial();
  changeAll(graph);
  graph.takeBack();
  ASSERT_EQ(graph.keyframes().size(), 2U);
  for (const auto& [id, node] : before.keyframes()) {
    EXPECT_EQ(graph.keyframes().at(id).T_map_cam.matrix(), node.T_map_cam.matrix());
    EXPECT_EQ(graph.keyframes().at(id).keypointOf, node.keypointOf);
    EXPECT_EQ(graph.keyframes().at(id).submap, node.submap);
  }
  ASSERT_EQ(graph.points().size(), before.points().size());
  for (const auto& [id, node] : before.points()) {
    EXPECT_EQ(graph.points().at(id).point.p_map_m, node.point.p_map_m) << id;
    EXPECT_EQ(graph.points().at(id).point.viewedFrom_map_m, node.point.viewedFrom_map_m) << id;
    EXPECT_EQ(graph.points().at(id).seenBy, node.seenBy) << id;
  }
  graph.insert(handMadeKeyframe(3, {4, 2}, 2));
  EXPECT_THAT(graph.keyframes().at(3).keypointOf, ElementsAre(Pair(2, 1), Pair(4, 0))) << "nothing was fused";
  EXPECT_EQ(graph.keyframes().at(3).submap, 2U) << "nothing was joined";
}

TEST(KeyframeGraph, WhatATrialChangedStaysWhenItEnds) {
  KeyframeGraph graph;
  graph.insert(handMadeKeyframe(1, {1, 2, 3}));
  graph.insert(handMadeKeyframe(2, {4, 2, 5}, 2));
  graph.beginTrial();
  changeAll(graph);
  graph.endTrial();
  graph.takeBack();  // there is nothing any more
  EXPECT_EQ(graph.points().count(4), 0U);
  EXPECT_EQ(graph.keyframes().at(2).submap, 1U);
  EXPECT_TRUE(graph.keyframes().at(1).T_map_cam.isApprox(makePose({2, 0, 0})));
}

}  // namespace
}  // namespace wardslam::graph
