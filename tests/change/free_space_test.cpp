#include "free_space.h"

#include <gtest/gtest.h>

#include "change/moving_scene.h"

namespace wardslam::change {
namespace {

using test::camera;

cv::Mat wall(float depth_m) { return {test::kHeight, test::kWidth, CV_32FC1, cv::Scalar(depth_m)}; }

cv::Mat wallWithBox(float wall_m, cv::Rect box, float box_m) {
  cv::Mat depth_m = wall(wall_m);
  depth_m(box).setTo(box_m);
  return depth_m;
}

Seen at(const cv::Mat& space, cv::Point full_px) {
  return static_cast<Seen>(space.at<std::uint8_t>(full_px / DepthGrid::kStep_px));
}

Eigen::Isometry3d moved(double x, double y, double z) { return Eigen::Isometry3d(Eigen::Translation3d(x, y, z)); }

int pixels(const cv::Mat& space, Seen kind) { return cv::countNonZero(space == static_cast<int>(kind)); }

TEST(FreeSpace, TheSameWallIsTheSame) {
  const DepthGrid view(wall(3.0F), camera());
  EXPECT_EQ(view.size(), cv::Size(160, 120));
  EXPECT_EQ(pixels(view.compareWith(view, Eigen::Isometry3d::Identity()), Seen::Same), 160 * 120);
}

TEST(FreeSpace, WhatStandsWhereAnEarlierImageSawTheWallHasCome) {
  const DepthGrid past(wall(3.0F), camera());
  const DepthGrid now(wallWithBox(3.0F, {200, 100, 120, 200}, 1.5F), camera());
  const cv::Mat space = now.compareWith(past, Eigen::Isometry3d::Identity());
  EXPECT_EQ(pixels(space, Seen::Through), 30 * 50);
  EXPECT_EQ(at(space, {260, 200}), Seen::Through);
  EXPECT_EQ(at(space, {100, 200}), Seen::Same);
}

TEST(FreeSpace, WhatWasHiddenIsUnknown) {
  const DepthGrid past(wallWithBox(3.0F, {200, 100, 120, 200}, 1.5F), camera());
  const DepthGrid now(wall(3.0F), camera());
  const cv::Mat space = now.compareWith(past, Eigen::Isometry3d::Identity());
  EXPECT_EQ(at(space, {260, 200}), Seen::Unknown) << "the wall behind the box that left";
  EXPECT_EQ(pixels(space, Seen::Through), 0);
}

TEST(FreeSpace, KnowsThatTheCameraMoved) {
  const DepthGrid past(wall(3.0F), camera());
  const DepthGrid now(wall(2.5F), camera());
  const cv::Mat space = now.compareWith(past, moved(0, 0, 0.5));  // half a metre closer to the same wall
  EXPECT_EQ(pixels(space, Seen::Same), 160 * 120);
  EXPECT_EQ(pixels(now.compareWith(past, Eigen::Isometry3d::Identity()), Seen::Through), 160 * 120)
      << "without moving, the wall would have come";
}

TEST(FreeSpace, WhatIsOutOfTheEarlierViewIsUnknown) {
  const DepthGrid view(wall(2.0F), camera());
  // One metre to the right at 2 m: 250 px; only the left 390 px were seen.
  const cv::Mat space = view.compareWith(view, moved(1.0, 0, 0));
  EXPECT_EQ(at(space, {380, 240}), Seen::Same);
  EXPECT_EQ(at(space, {400, 240}), Seen::Unknown);
}

TEST(FreeSpace, NoiseIsNoMotion) {
  // sigma(3 m) = 0.0140 m in both: 4 sigma and 0.04 m make 0.119 m.
  const DepthGrid past(wall(3.0F), camera());
  EXPECT_EQ(pixels(DepthGrid(wall(2.90F), camera()).compareWith(past, Eigen::Isometry3d::Identity()), Seen::Through),
            0);
  EXPECT_EQ(pixels(DepthGrid(wall(2.87F), camera()).compareWith(past, Eigen::Isometry3d::Identity()), Seen::Through),
            160 * 120);
}

TEST(FreeSpace, AnEdgeMayBeOffByTwoPixels) {
  const DepthGrid past(wallWithBox(3.0F, {200, 100, 120, 200}, 1.5F), camera());
  const DepthGrid shifted(wallWithBox(3.0F, {208, 100, 120, 200}, 1.5F), camera());
  const cv::Mat space = shifted.compareWith(past, Eigen::Isometry3d::Identity());
  EXPECT_EQ(pixels(space, Seen::Through), 0) << "two of the small image's pixels";
}

TEST(FreeSpace, WithoutDepthNothingIsKnown) {
  const DepthGrid known(wall(3.0F), camera());
  const DepthGrid blind(wall(0.0F), camera());
  EXPECT_EQ(pixels(blind.compareWith(known, Eigen::Isometry3d::Identity()), Seen::Unknown), 160 * 120);
  EXPECT_EQ(pixels(known.compareWith(blind, Eigen::Isometry3d::Identity()), Seen::Unknown), 160 * 120);
}

TEST(FreeSpace, SharesNothingWithTheViewOfAnotherCamera) {
  core::CameraModel tele = camera();
  tele.fx_px = tele.fy_px = 2 * tele.fx_px;
  const DepthGrid wide(wall(3.0F), camera());
  const DepthGrid shared(wall(3.0F), tele, &wide);
  const DepthGrid own(wall(3.0F), tele);
  // One metre beside, the narrow view sees another part than the wide one would.
  const auto toTheSide = moved(1.0, 0, 0);
  EXPECT_EQ(cv::norm(shared.compareWith(wide, toTheSide), own.compareWith(wide, toTheSide)), 0.0);
  EXPECT_GT(cv::norm(wide.compareWith(wide, toTheSide), own.compareWith(wide, toTheSide)), 0.0);
}

TEST(FreeSpace, TakesTheLensIntoAccount) {
  core::CameraModel bent = camera();
  bent.k1 = 0.2;
  // A slanted wall, as this lens sees it from the same place: equal everywhere only if both ways through the lens
  // agree.
  cv::Mat depth_m = wall(3.0F);
  for (int x = 0; x < depth_m.cols; ++x) depth_m.col(x).setTo(2.0F + 0.004F * static_cast<float>(x));
  const DepthGrid view(depth_m, bent);
  const cv::Mat space = view.compareWith(view, Eigen::Isometry3d::Identity());
  EXPECT_EQ(pixels(space, Seen::Same), 160 * 120);
}

}  // namespace
}  // namespace wardslam::change
