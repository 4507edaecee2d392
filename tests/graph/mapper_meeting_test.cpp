#include <gtest/gtest.h>

#include <algorithm>

#include "graph/meeting_runs.h"
#include "wardslam/graph/mapper.h"

namespace wardslam::graph {
namespace {

TEST(MapperMeetingTest, RunsThatSawOnePlaceBecomeOne) {
  const MeetingRuns runs(true);
  Mapper mapper(fewAndFast(), {});
  mapper.restore(runs.first);
  std::size_t heard = 0;
  std::vector<odometry::SubmapJoin> joins;
  mapper.meet(runs.second, [&](const odometry::MapUpdate& update) {
    ++heard;
    if (update.joined) joins.push_back(*update.joined);
  });
  EXPECT_EQ(heard, 12U) << "once for every keyframe of the second run";
  ASSERT_EQ(joins.size(), 1U);
  EXPECT_EQ(joins[0].from, 2U);
  EXPECT_EQ(joins[0].into, 1U) << "in the frame of the first";
  for (const auto& keyframe : runs.first.keyframes) {
    EXPECT_TRUE(mapper.graph().keyframes().at(keyframe->id).T_map_cam.matrix() == keyframe->T_map_cam.matrix())
        << keyframe->id << " stays, to the bit";
  }
  for (KeyframeId id = 17; id <= 28; ++id) {
    const auto& node = mapper.graph().keyframes().at(id);
    EXPECT_EQ(node.submap, 1U);
    EXPECT_LT(test::distance_m(node.T_map_cam, runs.walk.T_first_cam(id)), 0.03) << id;
  }
  const auto seeTheSame = mapper.graph().covisible(20);
  EXPECT_TRUE(std::any_of(seeTheSame.begin(), seeTheSame.end(), [](const auto& other) { return other.first <= 16; }))
      << "points of both runs are one";
}

TEST(MapperMeetingTest, RunsThatSawNothingInCommonStayAsTheyAre) {
  const MeetingRuns runs(false);
  Mapper mapper(fewAndFast(), {});
  mapper.restore(runs.first);
  mapper.meet(runs.second, [](const odometry::MapUpdate& update) { EXPECT_FALSE(update.joined); });
  EXPECT_EQ(mapper.pieces().sizes().size(), 2U);
  for (const auto& keyframe : runs.second.keyframes) {
    EXPECT_TRUE(mapper.graph().keyframes().at(keyframe->id).T_map_cam.matrix() == keyframe->T_map_cam.matrix());
  }
}

}  // namespace
}  // namespace wardslam::graph
