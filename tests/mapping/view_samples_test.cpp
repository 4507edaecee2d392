#include "view_samples.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "wardslam/core/depth_noise.h"
#include "wardslam/core/view_rays.h"

namespace wardslam::mapping {
namespace {

constexpr float kCell_m = 0.5F;

/// Four pixels in a row, 2 m away, whose points are (-3, -1, 1, 3) · 0.1 m to the right.
View fourPixels() {
  View view;
  view.camera.width_px = 4;
  view.camera.height_px = 1;
  view.camera.fx_px = view.camera.fy_px = 10.0;
  view.camera.cx_px = 1.5;
  view.camera.cy_px = 0.0;
  view.color_bgr = cv::Mat(1, 4, CV_8UC3, cv::Scalar(10, 20, 30));
  view.depth_m = cv::Mat(1, 4, CV_32FC1, cv::Scalar(2.0));
  return view;
}

std::vector<Sample> sample(const View& view, const cv::Mat& usable,
                           const Eigen::Isometry3d& T_map_cam = Eigen::Isometry3d::Identity()) {
  return sampleView(view, T_map_cam, core::viewRays(view.camera), usable, kCell_m, 1);
}

cv::Mat all() { return cv::Mat(1, 4, CV_8UC1, cv::Scalar(255)); }

TEST(ViewSamples, AreMeansOfThePixelsInACell) {
  View view = fourPixels();
  view.color_bgr.at<cv::Vec3b>(0, 2) = {50, 60, 70};
  const auto samples = sample(view, all());  // cells end at x = 0
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[0].pixels, 2);
  EXPECT_TRUE(samples[0].p_map_m.isApprox(Eigen::Vector3f(-0.2F, 0, 2), 1e-5F));
  EXPECT_TRUE(samples[1].p_map_m.isApprox(Eigen::Vector3f(0.2F, 0, 2), 1e-5F));
  EXPECT_TRUE(samples[1].color_rgb.isApprox(Eigen::Vector3f(50, 40, 30), 1e-5F)) << "red first";
  EXPECT_FLOAT_EQ(samples[0].depth_m, 2.0F);
  EXPECT_FLOAT_EQ(samples[0].sigma_m, static_cast<float>(core::DepthNoise().sigma_m(2.0)));
}

TEST(ViewSamples, LieInTheMapFrame) {
  Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
  T_map_cam.translation() = Eigen::Vector3d(0, 0, 10);
  const auto samples = sample(fourPixels(), all(), T_map_cam);
  ASSERT_FALSE(samples.empty());
  EXPECT_FLOAT_EQ(samples[0].p_map_m.z(), 12.0F);
  EXPECT_FLOAT_EQ(samples[0].depth_m, 2.0F) << "depth stays that from the view";
}

TEST(ViewSamples, LeaveUnusablePixelsOut) {
  cv::Mat usable = all();
  usable.at<std::uint8_t>(0, 0) = 0;
  const auto samples = sample(fourPixels(), usable);
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[0].pixels, 1);
  EXPECT_NEAR(samples[0].p_map_m.x(), -0.1F, 1e-5F);
}

TEST(ViewSamples, KeepInstancesInOneCellApart) {
  View view = fourPixels();
  view.segmentation.classIds = cv::Mat(1, 4, CV_8UC1, cv::Scalar(57));
  view.segmentation.instanceIds = cv::Mat(1, 4, CV_16UC1, cv::Scalar(1));
  view.segmentation.instanceIds.at<std::uint16_t>(0, 1) = 2;
  const auto samples = sample(view, all());
  ASSERT_EQ(samples.size(), 3U);
  EXPECT_EQ(samples[0].instance, 1);
  EXPECT_EQ(samples[1].instance, 2);
  EXPECT_EQ(samples[2].pixels, 2);
}

TEST(ViewSamples, TellCellsApartOnBothSidesOfTheOrigin) {
  EXPECT_EQ(cellOf({0.1F, 0.1F, 0.1F}, kCell_m), cellOf({0.4F, 0.4F, 0.4F}, kCell_m));
  EXPECT_NE(cellOf({0.1F, 0.1F, 0.1F}, kCell_m), cellOf({-0.1F, 0.1F, 0.1F}, kCell_m));
  EXPECT_NE(cellOf({0.1F, 0.1F, -0.1F}, kCell_m), cellOf({0.1F, -0.1F, 0.1F}, kCell_m));
}

}  // namespace
}  // namespace wardslam::mapping
