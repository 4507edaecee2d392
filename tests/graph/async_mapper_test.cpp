#include "wardslam/graph/async_mapper.h"

#include <gmock/gmock.h>

#include <chrono>
#include <opencv2/core.hpp>
#include <thread>

#include "graph/synthetic_walk.h"

namespace wardslam::graph {
namespace {

using std::chrono_literals::operator""ms;

std::unique_ptr<Mapper> makeMapper(const GraphOptions& options = {}) {
  return std::make_unique<Mapper>(options, odometry::OdometryOptions{});
}

std::vector<odometry::MapUpdate> waitForUpdates(AsyncMapper& mapper) {
  while (true) {
    auto updates = mapper.takeUpdates();
    if (!updates.empty()) return updates;
    std::this_thread::sleep_for(1ms);
  }
}

TEST(AsyncMapper, FedSlowlyItMakesTheMapOfThePlainOne) {
  const auto keyframes = test::SyntheticWalk({0.5, 0.5, 0}, 800).walk(8);
  const auto plain = makeMapper();
  AsyncMapper async(makeMapper());
  for (const auto& keyframe : keyframes) {
    const auto expected = plain->insert(keyframe);
    async.insert(keyframe);
    const auto updates = waitForUpdates(async);
    ASSERT_EQ(updates.size(), 1U);
    EXPECT_EQ(updates[0].removedPoints, expected.removedPoints);
    EXPECT_EQ(updates[0].p_map_m, expected.p_map_m);
  }
  const auto finished = async.finish();
  ASSERT_EQ(finished->graph().keyframes().size(), keyframes.size());
  for (const auto& [id, node] : plain->graph().keyframes()) {
    const auto& other = finished->graph().keyframes().at(id);
    EXPECT_EQ(node.T_map_cam.matrix(), other.T_map_cam.matrix());
    EXPECT_EQ(node.keypointOf, other.keypointOf);
  }
}

TEST(AsyncMapper, FinishWorksEverythingIn) {
  const auto keyframes = test::SyntheticWalk({}, 800).walk(10);
  AsyncMapper async(makeMapper());
  for (const auto& keyframe : keyframes) async.insert(keyframe);
  const auto mapper = async.finish();
  EXPECT_EQ(mapper->graph().keyframes().size(), 10U);
}

TEST(AsyncMapper, CanBeGivenUpWithWorkPending) {
  const auto keyframes = test::SyntheticWalk({}, 800).walk(10);
  {
    AsyncMapper async(makeMapper());
    for (const auto& keyframe : keyframes) async.insert(keyframe);
  }
  for (const auto& keyframe : keyframes) EXPECT_EQ(keyframe.use_count(), 1) << "nobody holds it any more";
}

TEST(AsyncMapper, ThrowsWhatTheMapperThrew) {
  GraphOptions options;
  options.place_recognition.min_keyframe_gap = 1;
  test::SyntheticWalk walk({}, 400);
  std::vector<std::shared_ptr<odometry::Keyframe>> keyframes;
  for (int i = 0; i < 8; ++i) keyframes.push_back(walk.step());
  keyframes[1]->features.descriptors =
      cv::Mat(static_cast<int>(keyframes[1]->features.size()), 64, CV_8UC1, cv::Scalar(0));  // not ORB's
  AsyncMapper async(makeMapper(options));
  for (const auto& keyframe : keyframes) async.insert(keyframe);
  EXPECT_THROW((void)async.finish(), cv::Exception);
  EXPECT_THROW((void)async.takeUpdates(), cv::Exception);
}

}  // namespace
}  // namespace wardslam::graph
