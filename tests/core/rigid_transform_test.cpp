#include "wardslam/core/rigid_transform.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wardslam::core {
namespace {

TEST(RigidTransform, KeepsWhatIsRigid) {
  const Eigen::Isometry3d T = Eigen::Translation3d(1, -2, 3) * Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, 2) / 3);
  EXPECT_TRUE(rigid(T).isApprox(T, 1e-15));
}

TEST(RigidTransform, GivesARotationItsScaleBack) {
  const Eigen::Isometry3d T = Eigen::Translation3d(1, -2, 3) * Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, 2) / 3);
  Eigen::Isometry3d scaled = T;
  scaled.linear() *= 1.001;
  EXPECT_TRUE(rigid(scaled).isApprox(T, 1e-14)) << "and leaves the place alone";
}

TEST(IsRotation, KnowsOneFromAScaleAMirrorAndNothing) {
  const Eigen::Matrix3d R = Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, 2) / 3).toRotationMatrix();
  EXPECT_TRUE(isRotation(R, 1e-9));
  // R R^T is 1.001^2 I then: off by 0.002001 in each of three numbers, together 0.002001 * sqrt 3 = 0.00347.
  EXPECT_TRUE(isRotation(1.001 * R, 0.0035));
  EXPECT_FALSE(isRotation(1.001 * R, 0.0034));
  EXPECT_FALSE(isRotation(-R, 0.01)) << "a mirror";
  EXPECT_FALSE(isRotation(Eigen::Matrix3d::Zero(), 0.01));
  EXPECT_FALSE(isRotation(Eigen::Matrix3d::Constant(std::nan("")), 0.01));
}

}  // namespace
}  // namespace wardslam::core
