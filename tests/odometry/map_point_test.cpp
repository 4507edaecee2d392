#include "wardslam/odometry/map_point.h"

#include <gtest/gtest.h>

#include <cmath>

#include "wardslam/core/depth_noise.h"

namespace wardslam::odometry {
namespace {

core::CameraModel camera() {
  core::CameraModel camera;
  camera.fx_px = camera.fy_px = 500.0;
  camera.cx_px = 320.0;
  camera.cy_px = 240.0;
  return camera;
}

core::Keypoint keypoint(float x_px, float y_px, float depth_m, float scale = 1.0F) {
  core::Keypoint keypoint;
  keypoint.undistorted_px = {x_px, y_px};
  keypoint.depth_m = depth_m;
  keypoint.scale = scale;
  return keypoint;
}

/// Turned about the vertical axis (to the right where positive), standing at `t_m`.
Eigen::Isometry3d T_map_cam(const Eigen::Vector3d& t_m, double turn_rad = 0.0) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitY()).toRotationMatrix();
  T.translation() = t_m;
  return T;
}

const Eigen::Isometry3d kOrigin = Eigen::Isometry3d::Identity();

TEST(MapPoint, IsWhereTheKeypointMeasuresIt) {
  const auto point = makeMapPoint(keypoint(420, 140, 2.0F, 1.2F), {1, 2, 3}, camera(), T_map_cam({1, 0, 0}, M_PI / 2));
  // (0.4, -0.4, 2) in the camera's frame; a quarter turn to the right makes z to x and x to -z.
  EXPECT_TRUE(point.p_map_m.isApprox(Eigen::Vector3d(3, -0.4, -0.4), 1e-6)) << point.p_map_m.transpose();
  EXPECT_TRUE(point.viewedFrom_map_m.isApprox(Eigen::Vector3d(1, 0, 0)));
  EXPECT_EQ(point.descriptor, (OrbDescriptor{1, 2, 3}));
  EXPECT_NEAR(point.scale, 1.2, 1e-6);
}

TEST(MapPoint, FusionIsTheMeanWeightedByInformation) {
  // On the optical axis the three directions are independent: one pixel across, the Kinect's noise along.
  auto point = makeMapPoint(keypoint(320, 240, 2.0F), {}, camera(), kOrigin);
  EXPECT_NEAR(point.information_per_m2(0, 0), std::pow(500 / 2.0, 2), 1e-3);
  EXPECT_NEAR(point.information_per_m2(2, 2), std::pow(1 / core::DepthNoise().sigma_m(2.0), 2), 1);
  auto atAnEdge = keypoint(320, 240, 2.0F);
  atAnEdge.depthSpread_m = 1.0F;
  EXPECT_NEAR(makeMapPoint(atAnEdge, {}, camera(), kOrigin).information_per_m2(2, 2), 1.0, 1e-3);

  // Seen again from half a metre nearer, where it seems 2 cm farther and 5 px to the right.
  fuseMeasurement(point, keypoint(325, 240, 1.52F), camera(), T_map_cam({0, 0, 0.5}));
  const auto mean = [](double a, double sigmaOfA, double b, double sigmaOfB) {
    const double weightOfA = 1 / (sigmaOfA * sigmaOfA);
    const double weightOfB = 1 / (sigmaOfB * sigmaOfB);
    return (weightOfA * a + weightOfB * b) / (weightOfA + weightOfB);
  };
  const double x_m = 5.0 / 500.0 * 1.52;
  EXPECT_NEAR(point.p_map_m.x(), mean(0, 2.0 / 500, x_m, 1.52 / 500), 1e-4);
  EXPECT_NEAR(point.p_map_m.y(), 0.0, 1e-9);
  EXPECT_NEAR(point.p_map_m.z(), mean(2.0, core::DepthNoise().sigma_m(2.0), 2.02, core::DepthNoise().sigma_m(1.52)),
              1e-4);
}

TEST(MapPoint, OffTheAxisTheDepthErrorLiesAlongTheRay) {
  const auto point = makeMapPoint(keypoint(570, 240, 2.0F), {}, camera(), kOrigin);  // ray (0.5, 0, 1)
  const Eigen::Matrix3d covariance_m2 = point.information_per_m2.inverse();
  const double across_m = 2.0 / 500;
  const double along_m = core::DepthNoise().sigma_m(2.0);
  EXPECT_NEAR(covariance_m2(2, 2), along_m * along_m, 1e-9);
  EXPECT_NEAR(covariance_m2(0, 2), 0.5 * along_m * along_m, 1e-9);
  EXPECT_NEAR(covariance_m2(0, 0), across_m * across_m + 0.25 * along_m * along_m, 1e-9);
  EXPECT_NEAR(covariance_m2(1, 1), across_m * across_m, 1e-9);
}

TEST(MapPoint, ASecondLookFromTheSideFixesTheDepth) {
  // Far away the depth is poor; seen from a right angle the same direction is a matter of pixels.
  auto point = makeMapPoint(keypoint(320, 240, 4.0F), {}, camera(), kOrigin);
  const double before_m = std::sqrt(point.information_per_m2.inverse()(2, 2));
  fuseMeasurement(point, keypoint(320, 240, 4.0F), camera(), T_map_cam({-4, 0, 4}, M_PI / 2));
  const double after_m = std::sqrt(point.information_per_m2.inverse()(2, 2));
  EXPECT_NEAR(before_m, core::DepthNoise().sigma_m(4.0), 1e-6);
  EXPECT_LT(after_m, 4.0 / 500);
}

TEST(MapPoint, ProjectsWhereTheCameraSeesIt) {
  const auto point = makeMapPoint(keypoint(320, 240, 2.0F, 1.2F), {}, camera(), kOrigin);
  const auto from = [&](const Eigen::Isometry3d& T) { return project(7, point, camera(), T.inverse()); };

  const auto nearer = from(T_map_cam({0.1, 0, 1}));
  ASSERT_TRUE(nearer);
  EXPECT_EQ(nearer->id, 7U);
  EXPECT_EQ(nearer->descriptor, &point.descriptor);
  EXPECT_TRUE(nearer->undistorted_px.isApprox(Eigen::Vector2d(270, 240), 1e-6));
  EXPECT_NEAR(nearer->scale, 1.2 * 2.0 / std::hypot(0.1, 1.0), 1e-6) << "half as far: twice as large";
}

TEST(MapPoint, IsSeenAsFarOutAsTheLensShows) {
  core::CameraModel barrel = camera();
  barrel.k1 = -0.28;
  MapPoint point;
  point.p_map_m = {0.68, 0,
                   1.0};  // 0.68 (1 - 0.28 * 0.4624) = 0.592: within 320 px of the middle at 500 px; 0.68 is not
  const auto seen = project(7, point, barrel, kOrigin);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->undistorted_px.x(), 320 + 340, 1.0);
  EXPECT_NEAR(seen->raw_px.x(), 320 + 296, 1.0);
  EXPECT_NEAR(seen->depth_m, 1.0, 1e-12);
  EXPECT_FALSE(project(7, point, camera(), kOrigin));
}

TEST(MapPoint, IsNotSeenOutsideBehindTooNearOrFromTheSide) {
  const auto point = makeMapPoint(keypoint(320, 240, 2.0F), {}, camera(), kOrigin);
  const auto isSeen = [&](const Eigen::Isometry3d& T) { return project(7, point, camera(), T.inverse()).has_value(); };
  EXPECT_TRUE(isSeen(kOrigin));
  EXPECT_TRUE(isSeen(T_map_cam({1.27, 0, 0}))) << "2.5 px from the left border";
  EXPECT_FALSE(isSeen(T_map_cam({1.29, 0, 0}))) << "2.5 px beyond";
  EXPECT_FALSE(isSeen(T_map_cam({0, 0.98, 0}))) << "above the image";
  EXPECT_FALSE(isSeen(T_map_cam({0, 0, 3}))) << "behind the camera";
  EXPECT_FALSE(isSeen(T_map_cam({0, 0, 1.95}))) << "5 cm in front of the lens";
  // Round the point by 55 and by 65 degrees, looking at it.
  const auto round = [](double angle_rad) {
    return T_map_cam({-2 * std::sin(angle_rad), 0, 2 - 2 * std::cos(angle_rad)}, angle_rad);
  };
  EXPECT_TRUE(isSeen(round(55 * M_PI / 180)));
  EXPECT_FALSE(isSeen(round(65 * M_PI / 180)));
}

}  // namespace
}  // namespace wardslam::odometry
