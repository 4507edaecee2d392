#include "pose_pdf.h"

#include <gtest/gtest.h>

#include "wardslam/core/mrpt_compat.h"

namespace wardslam::mrpt_slam {
namespace {

Eigen::Isometry3d lookingAlongY() {
  Eigen::Isometry3d T(Eigen::Translation3d(3.0, -2.0, 0.5));
  T.linear() = Eigen::AngleAxisd(M_PI / 2.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return T;
}

TEST(PosePdf, TurnsWhatIsSureAheadOfTheBodyIntoTheMapFrame) {
  odometry::PoseCovariance ofBody = odometry::PoseCovariance::Zero();
  ofBody.diagonal() << 0.04, 0.01, 0.09, 0.001, 0.002, 0.003;  // ahead, left, up; about these
  const auto pdf = toGaussian(lookingAlongY(), ofBody);
  EXPECT_NEAR(pdf.mean.yaw(), M_PI / 2.0, 1e-12);
  EXPECT_NEAR(pdf.cov(0, 0), 0.01, 1e-9) << "x of the map is to the right of the body";
  EXPECT_NEAR(pdf.cov(1, 1), 0.04, 1e-9) << "y of the map is ahead";
  EXPECT_NEAR(pdf.cov(2, 2), 0.09, 1e-9);
  EXPECT_NEAR(pdf.cov(3, 3), 0.003, 1e-9) << "yaw is about the body's z axis";
  EXPECT_NEAR(pdf.cov(4, 4), 0.002, 1e-9);
  EXPECT_NEAR(pdf.cov(5, 5), 0.001, 1e-9);
}

TEST(PosePdf, ThereAndBackIsTheSame) {
  Eigen::Isometry3d T = lookingAlongY();
  T.linear() = T.linear() * Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  Eigen::Matrix<double, 6, 6> root;
  for (int i = 0; i < 36; ++i) root(i / 6, i % 6) = 0.01 * ((7 * i) % 11 - 5) + (i % 7 == 0 ? 0.1 : 0.0);
  const odometry::PoseCovariance covariance = root * root.transpose();
  EXPECT_TRUE(bodyCovariance(toGaussian(T, covariance)).isApprox(covariance, 1e-6));
}

/// Yaw jumps from π to -π there.
TEST(PosePdf, IsThatOfAnyOtherDirectionWhereTheBodyLooksBack) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const auto pdf = toGaussian(T, 0.01 * odometry::PoseCovariance::Identity());
  EXPECT_NEAR(pdf.cov(3, 3), 0.01, 1e-8);
}

}  // namespace
}  // namespace wardslam::mrpt_slam
