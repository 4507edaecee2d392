#include "wardslam/mapping/async_map_builder.h"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>
#include <vector>

namespace wardslam::mapping {
namespace {

std::unique_ptr<MapBuilder> builder() { return std::make_unique<MapBuilder>(MappingOptions{}, MapSetting{}); }

TEST(AsyncMapBuilderTest, WorksInOrderAndGivesTheBuilderBack) {
  AsyncMapBuilder async(builder());
  std::vector<int> done;
  async.post([&](MapBuilder&) { done.push_back(1); });
  async.postView([&](MapBuilder&) { done.push_back(2); }, false);
  async.post([&](MapBuilder&) { done.push_back(3); });
  EXPECT_NE(async.finish(), nullptr);
  EXPECT_EQ(done, (std::vector<int>{1, 2, 3}));
}

TEST(AsyncMapBuilderTest, LeavesOutOldViewsButNoKeyframesAndNoOtherWork) {
  AsyncMapBuilder async(builder());
  std::promise<void> go;
  std::promise<void> started;
  async.post([&](MapBuilder&) {
    started.set_value();
    go.get_future().wait();
  });
  started.get_future().wait();
  std::vector<int> done;
  async.post([&](MapBuilder&) { done.push_back(-1); });
  async.postView([&](MapBuilder&) { done.push_back(0); }, true);
  const int views = static_cast<int>(AsyncMapBuilder::kMaxWaiting) + 2;
  for (int i = 1; i < views; ++i) async.postView([&done, i](MapBuilder&) { done.push_back(i); }, false);
  EXPECT_EQ(async.dropped(), 2U);
  go.set_value();
  EXPECT_NE(async.finish(), nullptr);
  ASSERT_EQ(done.size(), AsyncMapBuilder::kMaxWaiting + 1);
  EXPECT_EQ(done[0], -1);
  EXPECT_EQ(done[1], 0);  // the keyframe
  EXPECT_EQ(done[2], 3);  // 1 and 2 were left out
}

TEST(AsyncMapBuilderTest, PassesFailuresOn) {
  AsyncMapBuilder async(builder());
  async.post([](MapBuilder&) { throw std::runtime_error("no space left"); });
  EXPECT_THROW((void)async.finish(), std::runtime_error);
}

TEST(AsyncMapBuilderTest, CanBeLeftWithWorkWaiting) {
  AsyncMapBuilder async(builder());
  for (int i = 0; i < 5; ++i) async.postView([](MapBuilder&) {}, false);
}

}  // namespace
}  // namespace wardslam::mapping
