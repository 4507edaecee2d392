#include "depth_registration.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace wardslam::sources {
namespace {

core::CameraModel camera(int width_px, int height_px, double f_px) {
  core::CameraModel model;
  model.width_px = width_px;
  model.height_px = height_px;
  model.fx_px = model.fy_px = f_px;
  model.cx_px = (width_px - 1) / 2.0;
  model.cy_px = (height_px - 1) / 2.0;
  return model;
}

cv::Mat plane(const core::CameraModel& model, float z_m) {
  return {model.height_px, model.width_px, CV_32FC1, cv::Scalar(z_m)};
}

int pixelsWithoutDepth(const cv::Mat& depth_m, const cv::Rect& where) {
  return where.area() - cv::countNonZero(depth_m(where));
}

TEST(DepthRegistration, OfOneCameraWithItselfChangesNothing) {
  const RgbdRig rig{camera(40, 30, 50), camera(40, 30, 50), Eigen::Isometry3d::Identity()};
  cv::Mat depth_m(30, 40, CV_32FC1);
  cv::randu(depth_m, 0.5, 4.0);
  depth_m.at<float>(7, 9) = 0.0F;
  // A hole stays a hole: each pixel covers itself alone.
  EXPECT_EQ(cv::norm(DepthRegistration(rig).apply(depth_m), depth_m, cv::NORM_INF), 0.0);
}

TEST(DepthRegistration, ShiftsAPlaneByItsDisparity) {
  // The colour camera is 0.1 m to the right: f b / z = 50 * 0.1 / 1 = 5 px to the left in its image.
  RgbdRig rig{camera(40, 30, 50), camera(40, 30, 50), Eigen::Isometry3d::Identity()};
  rig.T_color_depth.translation().x() = -0.1;
  const cv::Mat registered_m = DepthRegistration(rig).apply(plane(rig.depth, 1.0F));
  EXPECT_EQ(pixelsWithoutDepth(registered_m, {0, 0, 35, 30}), 0);
  EXPECT_EQ(cv::countNonZero(registered_m(cv::Rect(35, 0, 5, 30))), 0);  // beyond the edge of the depth image
  EXPECT_FLOAT_EQ(registered_m.at<float>(15, 20), 1.0F);
}

TEST(DepthRegistration, GivesDepthAlongTheAxisOfTheColourCamera) {
  // The colour camera is 0.25 m behind the depth camera: a plane at 1 m is at 1.25 m and appears 0.8 times as large.
  RgbdRig rig{camera(41, 31, 50), camera(41, 31, 50), Eigen::Isometry3d::Identity()};
  rig.T_color_depth.translation().z() = 0.25;
  const cv::Mat registered_m = DepthRegistration(rig).apply(plane(rig.depth, 1.0F));
  // Half sizes 20 and 15 px shrink to 16 and 12 px around the centre (20, 15).
  const cv::Rect seen(20 - 16, 15 - 12, 33, 25);
  EXPECT_EQ(pixelsWithoutDepth(registered_m, seen), 0);
  EXPECT_EQ(cv::countNonZero(registered_m), seen.area());
  EXPECT_FLOAT_EQ(registered_m.at<float>(15, 20), 1.25F);
}

TEST(DepthRegistration, TheNearestWins) {
  // A box face at 1 m over depth pixels 18..22 before a wall at 2 m; colour camera 0.08 m to the right: the wall moves
  // by 50 * 0.08 / 2 = 2 px, the box by 4 px, to 14..18, where it hides wall that the depth camera saw beside it.
  RgbdRig rig{camera(40, 30, 50), camera(40, 30, 50), Eigen::Isometry3d::Identity()};
  rig.T_color_depth.translation().x() = -0.08;
  cv::Mat depth_m = plane(rig.depth, 2.0F);
  depth_m(cv::Rect(18, 0, 5, 30)).setTo(1.0F);
  const cv::Mat registered_m = DepthRegistration(rig).apply(depth_m);
  const std::vector<float> row_m = registered_m.row(10);
  EXPECT_FLOAT_EQ(row_m[13], 2.0F);
  for (std::size_t u = 14; u <= 18; ++u) EXPECT_FLOAT_EQ(row_m[u], 1.0F) << u;
  // Behind the box's right edge: wall pixels 18..22 were hidden from the depth camera; they would lie at 16..20.
  for (std::size_t u = 19; u <= 20; ++u) EXPECT_FLOAT_EQ(row_m[u], 0.0F) << u;
  EXPECT_FLOAT_EQ(row_m[21], 2.0F);
}

TEST(DepthRegistration, ASmallDepthImageLeavesNoPinholes) {
  const core::CameraModel small = camera(40, 30, 50);
  const core::CameraModel large = camera(160, 120, 200);
  const RgbdRig rig{small, large, Eigen::Isometry3d(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()))};
  const cv::Mat registered_m = DepthRegistration(rig).apply(plane(small, 1.5F));
  // Rotated by 0.2 rad about y: u' = f tan(atan(u / f) + 0.2); the left edge moves from -20/50 to -0.184, that is to
  // pixel 79.5 - 200 * 0.184 = 43.
  EXPECT_EQ(pixelsWithoutDepth(registered_m, {44, 8, 116, 104}), 0);
}

TEST(DepthRegistration, HeedsTheLensesOfBothCameras) {
  core::CameraModel barrel = camera(64, 48, 40);
  barrel.k1 = -0.2;
  const core::CameraModel ideal = camera(64, 48, 40);
  cv::Mat depth_m = cv::Mat::zeros(48, 64, CV_32FC1);
  depth_m.at<float>(24, 56) = 2.0F;

  // The point seen by the ideal camera at (56, 24) has x = 24.5 / 40 = 0.6125, y = 0.5 / 40; a barrel lens with
  // k1 = -0.2 shows it at 1 - 0.2 * 0.3753 = 0.92494 of that: u = 31.5 + 24.5 * 0.92494 = 54.16.
  const cv::Mat throughBarrel = DepthRegistration({ideal, barrel, Eigen::Isometry3d::Identity()}).apply(depth_m);
  EXPECT_EQ(cv::countNonZero(throughBarrel), 1);
  EXPECT_FLOAT_EQ(throughBarrel.at<float>(24, 54), 2.0F);

  // And back: the barrel's pixel (56, 24) has x (1 - 0.2 x²) = 0.6125, so x = 0.6754 and u = 31.5 + 40 * 0.6754 = 58.5.
  const cv::Mat fromBarrel = DepthRegistration({barrel, ideal, Eigen::Isometry3d::Identity()}).apply(depth_m);
  EXPECT_GT(fromBarrel.at<float>(24, 58) + fromBarrel.at<float>(24, 59), 0.0F);
  EXPECT_EQ(fromBarrel.at<float>(24, 56), 0.0F);
}

TEST(DepthRegistration, WhatIsBehindTheColourCameraIsNotSeen) {
  RgbdRig rig{camera(40, 30, 50), camera(40, 30, 50), Eigen::Isometry3d::Identity()};
  rig.T_color_depth.translation().z() = -2.0;
  EXPECT_EQ(cv::countNonZero(DepthRegistration(rig).apply(plane(rig.depth, 1.0F))), 0);
}

}  // namespace
}  // namespace wardslam::sources
