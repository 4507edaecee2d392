#include "point_tracker.h"

#include <gtest/gtest.h>

#include "change/moving_scene.h"

namespace wardslam::change {
namespace {

using test::Scene;

std::vector<cv::Point2f> whereTheyAre(const PointTracker& tracker) {
  std::vector<cv::Point2f> pixels;
  for (const Track& track : tracker.tracks()) pixels.push_back(track.raw_px);
  return pixels;
}

/// Wall at 3 m, f = 500 px: 0.06 m to the right move the image 10 px to the left.
constexpr double kTenPixels_m = 0.06;

TEST(DepthAround, IsClearOnASurface) {
  const cv::Mat flat(100, 100, CV_32FC1, cv::Scalar(2.0F));
  const DepthAround around = depthAround(flat, {50, 50});
  EXPECT_FLOAT_EQ(static_cast<float>(around.clear_m), 2.0F);
  EXPECT_FLOAT_EQ(static_cast<float>(around.nearest_m), 2.0F);
  EXPECT_FLOAT_EQ(static_cast<float>(around.farthest_m), 2.0F);
}

TEST(DepthAround, IsNotClearBesideAnEdge) {
  cv::Mat edge(100, 100, CV_32FC1, cv::Scalar(2.0F));
  edge.colRange(60, 100).setTo(3.0F);
  EXPECT_EQ(depthAround(edge, {54, 50}).clear_m, 0.0) << "the window reaches 8 px";
  EXPECT_FLOAT_EQ(static_cast<float>(depthAround(edge, {54, 50}).farthest_m), 3.0F);
  EXPECT_GT(depthAround(edge, {50, 50}).clear_m, 0.0);
}

TEST(DepthAround, IsClearOnASlope) {
  cv::Mat slope(100, 100, CV_32FC1);
  for (int x = 0; x < 100; ++x) slope.col(x).setTo(2.0F + 0.006F * static_cast<float>(x));
  EXPECT_GT(depthAround(slope, {50, 50}).clear_m, 0.0) << "60 degrees at 2 m";
}

TEST(DepthAround, IsNoneWhereThereIsNone) {
  cv::Mat hole(100, 100, CV_32FC1, cv::Scalar(2.0F));
  hole(cv::Rect(48, 48, 5, 5)).setTo(0.0F);
  EXPECT_EQ(depthAround(hole, {50, 50}).clear_m, 0.0);
  EXPECT_GT(depthAround(hole, {50, 50}).nearest_m, 0.0) << "but around it";
  EXPECT_EQ(depthAround(hole, {3, 50}).nearest_m, 0.0) << "at the border of the image";
}

TEST(PointTracker, FollowsTheScene) {
  const Scene scene;
  PointTracker tracker({200});
  tracker.start(scene.frame(0, {0, 0, 0}), 1);
  ASSERT_EQ(tracker.tracks().size(), 200U);
  const auto before = whereTheyAre(tracker);

  tracker.follow(scene.frame(1, {kTenPixels_m, 0, 0}), 2, before, 1);
  ASSERT_GT(tracker.tracks().size(), 150U);
  for (const Track& track : tracker.tracks()) {
    ASSERT_EQ(track.positions.size(), 2U);
    const Eigen::Vector2d way = track.at(2)->undistorted_px - track.at(1)->undistorted_px;
    EXPECT_NEAR(way.x(), -10.0, 0.5);
    EXPECT_NEAR(way.y(), 0.0, 0.5);
    EXPECT_NEAR(track.positions.back().moved_px, 10.0, 0.5);
  }
}

TEST(PointTracker, StartsPointsWhereThereAreNone) {
  const Scene scene;
  PointTracker tracker({5000});
  const core::Frame frame = scene.frame(0, {0, 0, 0});
  tracker.start(frame, 1);
  const std::size_t first = tracker.tracks().size();
  EXPECT_EQ(first, frame.features.size()) << "they are 16 px apart";
  tracker.start(frame, 1);
  EXPECT_EQ(tracker.tracks().size(), first) << "all are followed already";
}

TEST(PointTracker, DropsWhatSlidesOntoAnotherSurface) {
  Scene scene;
  PointTracker tracker({1000});
  tracker.start(scene.frame(0, {0, 0, 0}), 1);
  core::Frame next = scene.frame(1, {0, 0, 0});
  next.depth_m(cv::Rect(320, 0, 320, 480)).setTo(2.0F);  // looks the same, but is a metre nearer
  tracker.follow(next, 2, whereTheyAre(tracker), 1);
  for (const Track& track : tracker.tracks()) EXPECT_LT(track.raw_px.x, 330.0F);
  EXPECT_GT(tracker.tracks().size(), 300U);
}

TEST(PointTracker, ForgetsOldPositions) {
  const Scene scene;
  PointTracker tracker({100});
  tracker.start(scene.frame(0, {0, 0, 0}), 1);
  for (std::uint64_t i = 2; i < 8; ++i) {
    tracker.follow(scene.frame(static_cast<double>(i), {0, 0, 0}), i, whereTheyAre(tracker), i - 2);
  }
  ASSERT_FALSE(tracker.tracks().empty());
  for (const Track& track : tracker.tracks()) {
    EXPECT_EQ(track.positions.size(), 3U);
    EXPECT_EQ(track.at(4), nullptr);
    EXPECT_EQ(track.at(8), nullptr);
    EXPECT_EQ(track.at(6)->frame, 6U);
  }
}

TEST(PointTracker, AnImageWithoutTextureLosesAll) {
  const Scene scene;
  PointTracker tracker({100});
  tracker.start(scene.frame(0, {0, 0, 0}), 1);
  core::Frame grey = scene.frame(1, {0, 0, 0});
  grey.gray.setTo(128);
  tracker.follow(grey, 2, whereTheyAre(tracker), 1);
  EXPECT_TRUE(tracker.tracks().empty());
}

}  // namespace
}  // namespace wardslam::change
