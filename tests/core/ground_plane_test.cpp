#include "wardslam/core/ground_plane.h"

#include <gtest/gtest.h>

namespace wardslam::core {
namespace {

constexpr double kTilt_rad = 10.0 * M_PI / 180.0;

/// Of a camera 1.1 m over the floor, image upright, that looks down by kTilt_rad: up is (0, -cos, -sin).
GroundPlane tilted() {
  GroundPlane plane;
  plane.normal_cam = Eigen::Vector3d(0.0, -std::cos(kTilt_rad), -std::sin(kTilt_rad));
  plane.height_m = 1.1;
  return plane;
}

TEST(GroundPlane, TellsHeightsOverItself) {
  EXPECT_NEAR(tilted().heightOf_m({0, 0, 0}), 1.1, 1e-12) << "the camera";
  // Along the optical axis the floor is at height / sin(tilt) = 6.335 m.
  EXPECT_NEAR(tilted().heightOf_m({0, 0, 1.1 / std::sin(kTilt_rad)}), 0.0, 1e-12);
  EXPECT_NEAR(tilted().heightOf_m({2.0, 1.1 / std::cos(kTilt_rad), 0}), 0.0, 1e-12) << "any x";
}

TEST(GroundPlane, PutsTheCameraUprightOverIt) {
  const Eigen::Isometry3d T = tilted().T_ground_cam();
  EXPECT_TRUE(T.translation().isApprox(Eigen::Vector3d(0, 0, 1.1), 1e-12));
  EXPECT_TRUE((T.linear() * tilted().normal_cam).isApprox(Eigen::Vector3d::UnitZ(), 1e-12));
  const Eigen::Vector3d p_cam_m(0.3, 0.2, 2.0);
  EXPECT_NEAR((T * p_cam_m).z(), tilted().heightOf_m(p_cam_m), 1e-12);
}

TEST(GroundPlane, IsZEqualsZeroOfAFrameThatIsLevel) {
  const GroundPlane plane = GroundPlane::atZero(tilted().T_ground_cam());
  EXPECT_TRUE(plane.normal_cam.isApprox(tilted().normal_cam, 1e-12));
  EXPECT_NEAR(plane.height_m, 1.1, 1e-12);
}

TEST(GroundPlane, HasTangentsThatSpanIt) {
  Eigen::Matrix3d axes;
  axes << tilted().tangents(), tilted().normal_cam;
  EXPECT_TRUE((axes.transpose() * axes).isIdentity(1e-12));
}

/// 0.01 rad and 0.02 m: at 3 m from the camera's foot, sqrt(0.03² + 0.02²) = 0.036 m.
TEST(GroundPlane, IsLessSureFartherAway) {
  GroundPlane plane;
  plane.height_m = 1.0;
  plane.covariance = Eigen::Vector3d(1e-4, 1e-4, 4e-4).asDiagonal();
  EXPECT_NEAR(plane.sigmaOf_m({0, 1.0, 0}), 0.02, 1e-9) << "the foot";
  EXPECT_NEAR(plane.sigmaOf_m({0, 1.0, 3.0}), 0.03606, 1e-5);
  EXPECT_NEAR(plane.sigmaOf_m({3.0, 1.0, 0}), 0.03606, 1e-5);
}

TEST(GroundPlane, IsTheSameFromAnotherCamera) {
  GroundPlane plane = tilted();
  plane.covariance = Eigen::Vector3d(1e-4, 4e-4, 9e-4).asDiagonal();
  Eigen::Isometry3d T_other_cam(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()));
  T_other_cam.translation() = Eigen::Vector3d(0.5, -0.3, 1.5);
  const GroundPlane seen = plane.seenFrom(T_other_cam);
  const Eigen::Vector3d points_cam_m[] = {{0, 0, 0}, {1, 0.5, 4}, {-2, 1, 3}};
  for (const Eigen::Vector3d& p_cam_m : points_cam_m) {
    EXPECT_NEAR(seen.heightOf_m(T_other_cam * p_cam_m), plane.heightOf_m(p_cam_m), 1e-12);
    EXPECT_NEAR(seen.sigmaOf_m(T_other_cam * p_cam_m), plane.sigmaOf_m(p_cam_m), 1e-12) << p_cam_m.transpose();
  }
}

}  // namespace
}  // namespace wardslam::core
