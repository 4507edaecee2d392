#include "wardslam/graph/saved_graph.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace wardslam::graph
