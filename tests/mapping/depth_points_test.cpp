#include "wardslam/mapping/depth_points.h"

#include <gtest/gtest.h>

#include <limits>

namespace wardslam::mapping {
namespace {

TEST(DepthPoints, AreThoseOfEveryFewPixelsThatHaveDepth) {
  cv::Mat depth_m(480, 640, CV_32FC1, cv::Scalar(0));
  depth_m.at<float>(100, 200) = 2.0F;
  depth_m.at<float>(100, 204) = 3.0F;
  depth_m.at<float>(101, 204) = 3.0F;  // between the rows
  const auto points = depthPoints(depth_m, {}, 4);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0].raw_px, cv::Point(200, 100));
  EXPECT_TRUE(
      points[0].p_cam_m.isApprox(Eigen::Vector3d((200 - 319.5) / 525.0 * 2.0, (100 - 239.5) / 525.0 * 2.0, 2.0), 1e-6));
  EXPECT_EQ(points[1].p_cam_m.z(), 3.0);
}

TEST(DepthPoints, AreNoneWhereDepthIsNoNumber) {
  cv::Mat depth_m(4, 4, CV_32FC1, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  depth_m.row(1).setTo(std::numeric_limits<float>::infinity());
  depth_m.row(2).setTo(-1.0F);
  depth_m.at<float>(3, 3) = 2.0F;
  EXPECT_EQ(depthPoints(depth_m, {}, 1).size(), 1U);
  EXPECT_TRUE(depthPoints({}, {}, 1).empty());
}

TEST(DepthPoints, LieWhereTheLensDoesNotBendThem) {
  core::CameraModel camera;
  camera.k1 = -0.2;
  cv::Mat depth_m(480, 640, CV_32FC1, cv::Scalar(0));
  depth_m.at<float>(0, 0) = 2.0F;
  const auto points = depthPoints(depth_m, camera, 1);
  ASSERT_EQ(points.size(), 1U);
  const Eigen::Vector2d seen_px = camera.projectDistorted(points[0].p_cam_m);
  EXPECT_NEAR(seen_px.x(), 0.0, 0.05);
  EXPECT_NEAR(seen_px.y(), 0.0, 0.05);
}

}  // namespace
}  // namespace wardslam::mapping
