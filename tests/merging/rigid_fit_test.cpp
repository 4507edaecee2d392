#include "rigid_fit.h"

#include <gtest/gtest.h>

namespace wardslam::merging {
namespace {

Eigen::Isometry3d pose(const Eigen::Vector3d& position_m, double yaw_rad = 0.0) {
  return Eigen::Translation3d(position_m) * Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());
}

/// Cameras on a row of 4 m in the second map; each stands by T_a_b in the first.
std::vector<PosePair> pairsBy(const Eigen::Isometry3d& T_a_b) {
  std::vector<PosePair> pairs;
  for (int i = 0; i < 5; ++i) {
    const Eigen::Isometry3d T_b_cam = pose({1.0 * i, 0.5, 1.2}, 0.3 * i);
    pairs.push_back({T_a_b * T_b_cam, T_b_cam});
  }
  return pairs;
}

TEST(RigidFitTest, FindsTheTransformOfExactPairs) {
  const Eigen::Isometry3d T_a_b = pose({3.0, -2.0, 0.1}, 0.7);
  const RigidFit fit = fitRigidly(pairsBy(T_a_b), {});
  EXPECT_TRUE(fit.T_a_b.isApprox(T_a_b, 1e-9));
  EXPECT_LT(fit.misfit_m, 1e-9);
  EXPECT_LT(fit.misfit_rad, 1e-9);
}

TEST(RigidFitTest, OnePairHasTheCovarianceOfOnePose) {
  graph::PoseGraphOptions noise;
  noise.position_sigma_m = 0.1;
  noise.rotation_sigma_rad = 0.01;
  const RigidFit fit = fitRigidly({{pose({0, 0, 0}), pose({0, 0, 0})}}, noise);
  EXPECT_NEAR(fit.covariance(0, 0), 0.01, 1e-9);
  EXPECT_NEAR(fit.covariance(5, 5), 1e-4, 1e-9);
  EXPECT_NEAR(fit.covariance(0, 5), 0.0, 1e-9);
}

TEST(RigidFitTest, FarFromTheOriginTurningAndShiftBelongTogether) {
  graph::PoseGraphOptions noise;
  noise.position_sigma_m = 0.1;
  noise.rotation_sigma_rad = 0.01;
  const RigidFit fit = fitRigidly({{pose({10, 0, 0}), pose({10, 0, 0})}}, noise);
  EXPECT_NEAR(fit.covariance(1, 1), 0.01 + 100.0 * 1e-4, 1e-9) << "the origin, seen from 10 m, goes with the turning";
  EXPECT_NEAR(fit.covariance(1, 5), -10.0 * 1e-4, 1e-9);
}

TEST(RigidFitTest, PairsThatContradictEachOtherMakeItLessSure) {
  graph::PoseGraphOptions noise;
  noise.position_sigma_m = 0.01;
  auto pairs = pairsBy(pose({1, 0, 0}));
  const double sure = fitRigidly(pairs, noise).covariance(0, 0);
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].T_a_cam.translation().x() += i % 2 == 0 ? 0.05 : -0.05;
  const RigidFit fit = fitRigidly(pairs, noise);
  EXPECT_GT(fit.covariance(0, 0), 2.0 * sure);
  EXPECT_NEAR(fit.misfit_m, 0.05, 0.005);
}

TEST(RigidFitTest, OneWrongPairCountsLittle) {
  auto pairs = pairsBy(pose({1, 2, 0}));
  pairs[2].T_a_cam.translation() += Eigen::Vector3d(0, 0, 3.0);
  EXPECT_LT((fitRigidly(pairs, {}).T_a_b.translation() - Eigen::Vector3d(1, 2, 0)).norm(), 0.05);
}

}  // namespace
}  // namespace wardslam::merging
