#include "wardslam/core/rigid_transform.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace wardslam::core
