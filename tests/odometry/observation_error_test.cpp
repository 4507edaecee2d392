#include "wardslam/odometry/observation_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wardslam::odometry {
namespace {

/// fx = fy = 500, principal point (320, 240).
core::CameraModel roundCamera() {
  core::CameraModel camera;
  camera.fx_px = camera.fy_px = 500.0;
  camera.cx_px = 320.0;
  camera.cy_px = 240.0;
  return camera;
}

core::Keypoint keypoint(float x_px, float y_px, float depth_m = 0.0F, float scale = 1.0F) {
  core::Keypoint keypoint;
  keypoint.undistorted_px = {x_px, y_px};
  keypoint.depth_m = depth_m;
  keypoint.scale = scale;
  return keypoint;
}

const PoseVector kAtOrigin = PoseVector::Zero();

TEST(ObservationError, IsInUnitsOfTheStandardDeviation) {
  const auto camera = roundCamera();
  const Eigen::Vector3d p_map_m(0.2, -0.1, 2.0);  // seen at (370, 215)
  const auto squared = [&](const core::Keypoint& seen, double pixelSigma_px = 1.0, double depthScale = 1.0) {
    return ObservationError(seen, camera, pixelSigma_px, depthScale).squared(kAtOrigin, p_map_m);
  };
  EXPECT_NEAR(squared(keypoint(370, 215)), 0.0, 1e-9);
  EXPECT_NEAR(squared(keypoint(373, 211)), 3 * 3 + 4 * 4, 1e-9);
  EXPECT_NEAR(squared(keypoint(373, 211), 2.0), 25.0 / 4.0, 1e-9);
  EXPECT_NEAR(squared(keypoint(373, 211, 0, 2.5F)), 25.0 / 6.25, 1e-9) << "coarser levels are less exact";

  const double sigma_m = 0.0012 + 0.0019 * 1.7 * 1.7;  // at the measured 2.1 m
  EXPECT_NEAR(squared(keypoint(370, 215, 2.1F)), std::pow(0.1 / sigma_m, 2), 1e-3);
  EXPECT_NEAR(squared(keypoint(370, 215, 2.1F), 1.0, 3.0), std::pow(0.1 / sigma_m, 2) / 9, 1e-3);
  auto atAnEdge = keypoint(370, 215, 2.1F);
  atAnEdge.depthSpread_m = 0.1F;
  EXPECT_NEAR(squared(atAnEdge), 0.01 / (0.01 + sigma_m * sigma_m), 1e-3);
  EXPECT_NEAR(squared(keypoint(373, 211, 2.1F)), 25 + std::pow(0.1 / sigma_m, 2), 1e-3);
}

TEST(ObservationError, APointBehindTheCameraIsInfinitelyWrong) {
  const auto camera = roundCamera();
  const auto seen = keypoint(320, 240);
  const ObservationError error(seen, camera, 1.0, 1.0);
  EXPECT_TRUE(std::isinf(error.squared(kAtOrigin, {0, 0, -2})));
  EXPECT_TRUE(std::isinf(error.squared(kAtOrigin, {0, 0, 0})));
}

TEST(ObservationError, SeesFromThePoseGiven) {
  const auto camera = roundCamera();
  Eigen::Isometry3d T_cam_map = Eigen::Isometry3d::Identity();
  T_cam_map.linear() = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T_cam_map.translation() = Eigen::Vector3d(0, 0, 1);
  // (0.4, 0, 1) turns to (0, 0.4, 1) and moves to (0, 0.4, 2): seen at (320, 340).
  const auto seen = keypoint(320, 340, 2.0F);
  EXPECT_NEAR(ObservationError(seen, camera, 1.0, 1.0).squared(toPoseVector(T_cam_map), {0.4, 0, 1}), 0.0, 1e-9);
}

TEST(PoseVector, GoesToAPoseAndBack) {
  for (const double angle_rad : {0.0, 1e-9, 0.7, M_PI - 1e-6, M_PI}) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = Eigen::AngleAxisd(angle_rad, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    T.translation() = Eigen::Vector3d(1, 2, 3);
    EXPECT_TRUE(toIsometry(toPoseVector(T)).isApprox(T, 1e-7)) << angle_rad;
  }
}

TEST(ChiSquare, HasADegreeOfFreedomMoreWithDepth) {
  EXPECT_EQ(chiSquareOf(keypoint(0, 0)), kChiSquareWithoutDepth);
  EXPECT_EQ(chiSquareOf(keypoint(0, 0, 1)), kChiSquareWithDepth);
  EXPECT_NEAR(std::exp(-kChiSquareWithoutDepth / 2), 0.05, 1e-4) << "closed form for two degrees of freedom";
}

}  // namespace
}  // namespace wardslam::odometry
