#include "wardslam/pipeline/map_keeper.h"

#include <gmock/gmock.h>

#include "graph/synthetic_walk.h"

namespace wardslam::pipeline {
namespace {

std::unique_ptr<graph::Mapper> makeMapper() {
  return std::make_unique<graph::Mapper>(graph::GraphOptions{}, odometry::OdometryOptions{});
}

TEST(MapKeeper, InTheCallingThreadUpdatesAreThereAtOnce) {
  MapKeeper keeper(makeMapper(), false);
  test::SyntheticWalk walk({}, 800);
  for (int i = 0; i < 4; ++i) {
    const auto keyframe = walk.step();
    keeper.insert(keyframe);
    const auto updates = keeper.takeUpdates();
    ASSERT_EQ(updates.size(), 1U);
    EXPECT_EQ(updates[0].T_map_cam.count(keyframe->id), i == 0 ? 0U : 1U) << "all but the first move";
    EXPECT_TRUE(keeper.takeUpdates().empty()) << "each is handed out once";
  }
  EXPECT_EQ(keeper.finish().graph().keyframes().size(), 4U);
}

TEST(MapKeeper, BothWaysHoldAllKeyframesInTheEnd) {
  const auto keyframes = test::SyntheticWalk({0.5, 0.5, 0}, 800).walk(6);
  MapKeeper atOnce(makeMapper(), false);
  MapKeeper behind(makeMapper(), true);
  for (const auto& keyframe : keyframes) {
    atOnce.insert(keyframe);
    behind.insert(keyframe);
  }
  const auto& expected = atOnce.finish().graph().keyframes();
  const auto& mapper = behind.finish();
  ASSERT_EQ(mapper.graph().keyframes().size(), expected.size());
  for (const auto& [id, node] : mapper.graph().keyframes()) {
    EXPECT_EQ(node.T_map_cam.matrix(), expected.at(id).T_map_cam.matrix());
  }
  EXPECT_EQ(&behind.finish(), &mapper) << "asking twice does no harm";
}

}  // namespace
}  // namespace wardslam::pipeline
