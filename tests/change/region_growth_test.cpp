#include "region_growth.h"

#include <gtest/gtest.h>

namespace wardslam::change {
namespace {

// At 1 m a cell is 0.1 m wide.
constexpr double kCell = 0.1;

cv::Mat board(float depth_m, int columns = 20, int rows = 1) { return {rows, columns, CV_32FC1, cv::Scalar(depth_m)}; }

int moving(const cv::Mat& regions) { return cv::countNonZero(regions); }

TEST(RegionGrowth, ReachesAsFarAsItMay) {
  const cv::Mat regions = growRegions(board(1.0F), kCell, {{{10, 0}, true}}, 0.35);
  EXPECT_EQ(moving(regions), 7) << "three cells of 0.1 m to either side";
  EXPECT_EQ(regions.at<std::uint8_t>(0, 7), 255);
  EXPECT_EQ(regions.at<std::uint8_t>(0, 6), 0);
  EXPECT_EQ(moving(growRegions(board(2.0F), kCell, {{{10, 0}, true}}, 0.45)), 5) << "cells are 0.2 m wide at 2 m";
}

TEST(RegionGrowth, WalksDiagonally) {
  const cv::Mat regions = growRegions(board(1.0F, 9, 9), kCell, {{{4, 4}, true}}, 0.15);
  EXPECT_EQ(moving(regions), 9) << "0.141 m to the corners";
}

TEST(RegionGrowth, StopsHalfwayToASeedAtRest) {
  const cv::Mat regions = growRegions(board(1.0F), kCell, {{{4, 0}, true}, {{11, 0}, false}}, 1.0);
  EXPECT_EQ(moving(regions), 8) << "cells 0 to 7";
  EXPECT_EQ(regions.at<std::uint8_t>(0, 7), 255);
  EXPECT_EQ(regions.at<std::uint8_t>(0, 8), 0);
}

TEST(RegionGrowth, AHandicapMovesTheBorder) {
  const cv::Mat regions = growRegions(board(1.0F), kCell, {{{4, 0}, true}, {{11, 0}, false, 0.25}}, 1.0);
  EXPECT_EQ(moving(regions), 9) << "0.4 m from the one, 0.3 m and 0.25 m from the other";
}

TEST(RegionGrowth, DoesNotCrossAnEdge) {
  cv::Mat depth_m = board(1.0F);
  depth_m.colRange(12, 20).setTo(1.5F);
  const cv::Mat regions = growRegions(depth_m, kCell, {{{10, 0}, true}}, 1.0);
  EXPECT_EQ(regions.at<std::uint8_t>(0, 11), 255);
  EXPECT_EQ(regions.at<std::uint8_t>(0, 12), 0);
}

TEST(RegionGrowth, FollowsASlantedSurface) {
  cv::Mat depth_m = board(1.0F, 4);
  for (int i = 0; i < 4; ++i) depth_m.at<float>(0, i) = 1.0F + 0.1F * static_cast<float>(i);
  EXPECT_EQ(moving(growRegions(depth_m, kCell, {{{0, 0}, true}}, 0.15)), 2) << "a step is 0.141 m long, not 0.1 m";
}

TEST(RegionGrowth, PassesHolesAtTwiceTheLength) {
  cv::Mat depth_m = board(1.0F);
  depth_m.colRange(11, 13).setTo(0.0F);
  const auto reached = [&](double reach_m) { return moving(growRegions(depth_m, kCell, {{{10, 0}, true}}, reach_m)); };
  EXPECT_EQ(reached(0.45), 7) << "four to the left, itself, two holes";
  EXPECT_EQ(reached(0.55), 9) << "and the first cell behind the holes";

  depth_m.colRange(13, 20).setTo(1.6F);
  EXPECT_EQ(reached(0.95), 12) << "but not onto something else behind: nine to the left, itself, two holes";
}

TEST(RegionGrowth, ASeedWithoutDepthDoesNothing) {
  EXPECT_EQ(moving(growRegions(board(0.0F), kCell, {{{10, 0}, true}}, 1.0)), 0);
  EXPECT_EQ(moving(growRegions(board(1.0F), kCell, {}, 1.0)), 0);
}

}  // namespace
}  // namespace wardslam::change
