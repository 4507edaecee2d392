#include "wardslam/pipeline/run_statistics.h"

#include <gtest/gtest.h>

namespace wardslam::pipeline {
namespace {

using odometry::State;

core::Frame frameOf(std::size_t keypoints, std::size_t dynamic, const core::EventCounts& events = {}) {
  core::Frame frame;
  frame.features.keypoints.resize(keypoints);
  for (std::size_t i = 0; i < dynamic; ++i) frame.features.keypoints[i].motion = core::Motion::Dynamic;
  frame.events = events;
  return frame;
}

odometry::OdometryResult tracked(State state, bool isKeyframe = false) {
  odometry::OdometryResult result;
  result.state = state;
  if (isKeyframe) result.keyframe = std::make_shared<odometry::Keyframe>();
  return result;
}

TEST(RunStatistics, OfNothingIsZero) {
  const RunStatistics statistics;
  EXPECT_EQ(statistics.frames(), 0U);
  EXPECT_EQ(statistics.coverage(), 0.0);
  EXPECT_EQ(statistics.dynamicKeypointFraction(), 0.0);
  EXPECT_TRUE(statistics.events().empty());
}

TEST(RunStatistics, CountsAsByHand) {
  RunStatistics statistics;
  statistics.onFrame(frameOf(0, 0), tracked(State::Initialising));
  statistics.onFrame(frameOf(100, 30, {{"a.b", 1}}), tracked(State::Ok, true));
  statistics.onFrame(frameOf(60, 10, {{"a.b", 2}, {"c.d", 1}}), tracked(State::Ok));
  statistics.addUnusable();
  statistics.onFrame(frameOf(40, 0), tracked(State::Lost));
  EXPECT_EQ(statistics.frames(), 5U);
  EXPECT_EQ(statistics.unusableFrames(), 1U);
  EXPECT_EQ(statistics.framesTracked(), 2U);
  EXPECT_EQ(statistics.coverage(), 0.4);
  EXPECT_EQ(statistics.keyframes(), 1U);
  EXPECT_EQ(statistics.dynamicKeypointFraction(), 0.2) << "40 of 200";
  EXPECT_EQ(statistics.events(), (core::EventCounts{{"a.b", 3}, {"c.d", 1}}));
}

TEST(RunStatistics, TellsTheAgeOfMasks) {
  RunStatistics statistics;
  EXPECT_EQ(statistics.maskAge().p95_ms, 0);
  core::Frame frame;
  frame.segmentationAge_frames = 99;
  statistics.onFrame(frame, tracked(State::Ok));  // without masks they have no age
  frame.segmentation.classIds = cv::Mat(2, 2, CV_8UC1);
  for (int i = 1; i <= 20; ++i) {
    frame.segmentationAge_frames = i;
    frame.segmentationAge_s = 0.03 * i + 0.0004;
    statistics.onFrame(frame, tracked(State::Ok));
  }
  EXPECT_EQ(statistics.maskAge().median_frames, 10);
  EXPECT_EQ(statistics.maskAge().p95_frames, 19);
  EXPECT_EQ(statistics.maskAge().median_ms, 300);
  EXPECT_EQ(statistics.maskAge().p95_ms, 570);
}

TEST(RunStatistics, ALossIsCountedOnceWhileItLasts) {
  RunStatistics statistics;
  for (const State state :
       {State::Initialising, State::Ok, State::Lost, State::Lost, State::Ok, State::Ok, State::Lost, State::Ok}) {
    statistics.onFrame(frameOf(1, 0), tracked(state));
  }
  EXPECT_EQ(statistics.lostEvents(), 2U);
  EXPECT_EQ(statistics.framesTracked(), 4U);
}

TEST(RunStatistics, NeverHavingFoundAPoseIsNoLoss) {
  RunStatistics statistics;
  for (int i = 0; i < 3; ++i) statistics.onFrame(frameOf(1, 0), tracked(State::Initialising));
  EXPECT_EQ(statistics.lostEvents(), 0U);
  EXPECT_EQ(statistics.coverage(), 0.0);
}

TEST(RunStatistics, TellsWhatTrackingWentBy) {
  RunStatistics statistics;
  odometry::OdometryResult result = tracked(State::Ok);
  result.readout_s = 0.01;
  statistics.onFrame(frameOf(0, 0), result);
  result.isHeldByDepth = true;
  result.readout_s = 0.02;
  statistics.onFrame(frameOf(0, 0), result);
  EXPECT_EQ(statistics.framesHeldByDepth(), 1U);
  EXPECT_EQ(statistics.readout_s(), 0.02) << "the last is the best";
}

}  // namespace
}  // namespace wardslam::pipeline
