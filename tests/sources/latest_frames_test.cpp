#include "wardslam/sources/latest_frames.h"

#include <gtest/gtest.h>

#include <thread>

namespace wardslam::sources {
namespace {

using namespace std::chrono_literals;

TEST(LatestFrames, GivesFramesInOrder) {
  LatestFrames frames(2);
  frames.push("a");
  frames.push("b");
  EXPECT_EQ(frames.pop(0ms), "a");
  EXPECT_EQ(frames.pop(0ms), "b");
  EXPECT_EQ(frames.pop(0ms), std::nullopt);
  EXPECT_EQ(frames.skipped(), 0U);
}

TEST(LatestFrames, TheOldestGiveWay) {
  LatestFrames frames(2);
  for (const char* frame : {"a", "b", "c", "d", "e"}) frames.push(frame);
  EXPECT_EQ(frames.pop(0ms), "d");
  EXPECT_EQ(frames.pop(0ms), "e");
  EXPECT_EQ(frames.pushed(), 5U);
  EXPECT_EQ(frames.skipped(), 3U);
}

TEST(LatestFrames, DiscardedOnesCountAsSkipped) {
  LatestFrames frames(2);
  frames.push("a");
  frames.push("b");
  frames.discard();
  EXPECT_EQ(frames.pop(0ms), std::nullopt);
  EXPECT_EQ(frames.skipped(), 2U);
}

TEST(LatestFrames, WakesWhoWaits) {
  LatestFrames frames(1);
  std::thread camera([&] { frames.push("a"); });
  EXPECT_EQ(frames.pop(10s), "a");
  camera.join();
}

TEST(LatestFrames, IsDrainedWhenClosedAndEmpty) {
  LatestFrames frames(1);
  EXPECT_FALSE(frames.isDrained());
  frames.push("a");
  frames.close();
  EXPECT_FALSE(frames.isDrained());
  EXPECT_EQ(frames.pop(10s), "a");
  EXPECT_TRUE(frames.isDrained());
  EXPECT_EQ(frames.pop(10s), std::nullopt);  // at once
}

}  // namespace
}  // namespace wardslam::sources
