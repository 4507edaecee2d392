#include "wardslam/odometry/pose_solver.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "wardslam/core/depth_noise.h"

namespace wardslam::odometry {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Points of the map seen from a known pose, with the noise the solver reckons with.
class PoseSolverTest : public ::testing::Test {
 protected:
  PoseSolverTest() {
    T_cam_map_.linear() = Eigen::AngleAxisd(0.6, Eigen::Vector3d(0.3, 1.0, -0.2).normalized()).toRotationMatrix();
    T_cam_map_.translation() = Eigen::Vector3d(0.4, -0.2, 0.7);
  }

  [[nodiscard]] std::vector<PointObservation> observe(int count, bool withDepth) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::normal_distribution<double> normal;
    std::vector<PointObservation> observations;
    for (int i = 0; i < count; ++i) {
      const double z_m = 0.8 + 3.5 * unit(random_);
      const Eigen::Vector3d p_cam_m = camera_.unproject({640 * unit(random_), 480 * unit(random_)}, z_m);
      const Eigen::Vector2d px = camera_.project(p_cam_m) + Eigen::Vector2d(normal(random_), normal(random_));
      PointObservation observation;
      observation.p_map_m = T_cam_map_.inverse() * p_cam_m;
      observation.keypoint.undistorted_px = {static_cast<float>(px.x()), static_cast<float>(px.y())};
      const double depth_m = z_m + core::DepthNoise().sigma_m(z_m) * normal(random_);
      if (withDepth) observation.keypoint.depth_m = static_cast<float>(depth_m);
      observations.push_back(observation);
    }
    return observations;
  }

  /// Every third observation says anything.
  [[nodiscard]] std::vector<PointObservation> spoil(std::vector<PointObservation> observations) {
    std::uniform_real_distribution<float> unit(0.0F, 1.0F);
    for (std::size_t i = 0; i < observations.size(); i += 3) {
      auto& keypoint = observations[i].keypoint;
      keypoint.undistorted_px = {640.0F * unit(random_), 480.0F * unit(random_)};
      if (keypoint.hasDepth()) keypoint.depth_m = 0.8F + 3.5F * unit(random_);
    }
    return observations;
  }

  /// 5 cm and 3 degrees off.
  [[nodiscard]] Eigen::Isometry3d guess() const {
    return Eigen::Translation3d(0.03, -0.04, 0.0) * Eigen::AngleAxisd(0.052, Eigen::Vector3d(1, 1, 1).normalized()) *
           T_cam_map_;
  }

  /// The error of an estimate in units of the best possible covariance (Cramér–Rao): squared, with six degrees of
  /// freedom, so 6 on average for a perfect solver. `J`: d measurement / d (translation, rotation) of the camera frame.
  [[nodiscard]] double squaredError(const Eigen::Isometry3d& T_cam_map,
                                    const std::vector<PointObservation>& observations) const {
    Matrix6 information = Matrix6::Zero();
    for (const auto& [p_map_m, keypoint] : observations) {
      const Eigen::Vector3d p = T_cam_map_ * p_map_m;
      Eigen::Matrix3d J_point;
      J_point << camera_.fx_px / p.z(), 0, -camera_.fx_px * p.x() / (p.z() * p.z()),  //
          0, camera_.fy_px / p.z(), -camera_.fy_px * p.y() / (p.z() * p.z()),         //
          0, 0, keypoint.hasDepth() ? 1 / core::DepthNoise().sigma_m(p.z()) : 0.0;
      Eigen::Matrix<double, 3, 6> J_pose;
      J_pose << Eigen::Matrix3d::Identity(),
          (Eigen::Matrix3d() << 0, p.z(), -p.y(), -p.z(), 0, p.x(), p.y(), -p.x(), 0).finished();
      const Eigen::Matrix<double, 3, 6> J = J_point * J_pose;
      information += J.transpose() * J;
    }
    const Eigen::Isometry3d difference = T_cam_map * T_cam_map_.inverse();
    const Eigen::AngleAxisd turn(difference.linear());
    Vector6 error;
    error << difference.translation(), turn.angle() * turn.axis();
    return error.dot(information * error);
  }

  const core::CameraModel camera_;
  const PoseSolver solver_{{}};
  Eigen::Isometry3d T_cam_map_ = Eigen::Isometry3d::Identity();
  std::mt19937 random_{11};
};

TEST_F(PoseSolverTest, WeighsPointsByHowSureTheyAreStatic) {
  auto observations = observe(400, true);
  for (std::size_t i = 0; i < observations.size(); i += 2) {  // half of them moved a little, together
    observations[i].p_map_m += Eigen::Vector3d(0.006, 0.0, 0.0);
  }
  const auto error_m = [&] {
    const auto T_cam_map = PoseSolver({}).refine(observations, camera_, guess()).T_cam_map;
    return (T_cam_map.inverse().translation() - T_cam_map_.inverse().translation()).norm();
  };
  const double trusting_m = error_m();
  EXPECT_GT(trusting_m, 0.002);
  for (std::size_t i = 0; i < observations.size(); i += 2) observations[i].keypoint.staticProbability = 0.05F;
  EXPECT_LT(error_m(), 0.4 * trusting_m);
}

TEST_F(PoseSolverTest, IsAsExactAsTheNoiseAllows) {
  for (const bool withDepth : {true, false}) {
    constexpr int kTrials = 40;
    double sum = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
      const auto observations = observe(150, withDepth);
      const auto estimate = solver_.refine(observations, camera_, guess());
      sum += squaredError(estimate.T_cam_map, observations);
      EXPECT_GT(estimate.inliers, 150 * 88 / 100) << "95 % pass a test of 95 %";
    }
    // The mean of 40 such figures has a standard deviation of sqrt(12 / 40) = 0.55.
    EXPECT_NEAR(sum / kTrials, 6.0, 2.5) << (withDepth ? "with depth" : "without depth");
  }
}

/// Errors are as large as it says: six degrees of freedom.
TEST_F(PoseSolverTest, CovarianceIsThatOfTheBestEstimate) {
  constexpr int kTrials = 40;
  double sum = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto observations = observe(150, true);
    const PoseCovariance covariance = solver_.covariance(observations, camera_, T_cam_map_);
    EXPECT_TRUE(covariance.isApprox(covariance.transpose(), 1e-9));
    const auto estimate = solver_.refine(observations, camera_, guess());
    const Eigen::Isometry3d error = T_cam_map_ * estimate.T_cam_map.inverse();
    const Eigen::AngleAxisd turn(error.linear());
    Vector6 coordinates;
    coordinates << error.translation(), turn.angle() * turn.axis();
    sum += coordinates.dot(covariance.inverse() * coordinates);
  }
  EXPECT_NEAR(sum / kTrials, 6.0, 2.5);
}

/// Depths around it that spread by √3 σ make the depth of a key point twice as unsure.
TEST_F(PoseSolverTest, DepthsCountByHowFarThoseAroundSpread) {
  auto observations = observe(150, true);
  PoseSolverOptions unsure;
  unsure.depth_sigma_scale = 2.0;
  const PoseCovariance expected = PoseSolver(unsure).covariance(observations, camera_, T_cam_map_);
  for (auto& [p_map_m, keypoint] : observations) {
    keypoint.depthSpread_m =
        static_cast<float>(std::sqrt(3.0) * camera_.depthNoise.sigma_m(static_cast<double>(keypoint.depth_m)));
  }
  EXPECT_TRUE(solver_.covariance(observations, camera_, T_cam_map_).isApprox(expected, 1e-5));
}

TEST_F(PoseSolverTest, APriorCountsByItsCovariance) {
  const auto observations = observe(150, true);
  const Eigen::Isometry3d T_visual = solver_.refine(observations, camera_, guess()).T_cam_map;
  PosePrior prior;
  prior.T_cam_map = Eigen::Translation3d(0.002, 0.0, 0.0) * T_visual;
  const auto shift_m = [&](double sigma) {
    prior.covariance = sigma * sigma * PoseCovariance::Identity();
    return (solver_.refine(observations, camera_, guess(), &prior).T_cam_map.translation() - T_visual.translation())
        .norm();
  };
  EXPECT_NEAR(shift_m(1e-5), 0.002, 0.0004) << "surer than the image";
  EXPECT_LT(shift_m(0.05), 0.0001) << "less sure by far";
  EXPECT_GT(shift_m(0.001), shift_m(0.01));
}

TEST_F(PoseSolverTest, AnEqualPriorHalvesTheVariance) {
  const auto observations = observe(150, true);
  const PoseCovariance alone = solver_.covariance(observations, camera_, T_cam_map_);
  const PosePrior prior{T_cam_map_, alone};
  EXPECT_TRUE(solver_.covariance(observations, camera_, T_cam_map_, &prior).isApprox(0.5 * alone, 1e-6));
}

/// Wheels that slip by half a metre, and believe it to the millimetre.
TEST_F(PoseSolverTest, IsHardlyMovedByAPriorThatContradictsTheImage) {
  const auto observations = observe(150, true);
  const Eigen::Isometry3d T_visual = solver_.refine(observations, camera_, guess()).T_cam_map;
  const PosePrior prior{Eigen::Translation3d(0.5, 0.0, 0.0) * T_visual, 1e-6 * PoseCovariance::Identity()};
  const auto estimate = solver_.refine(observations, camera_, guess(), &prior);
  EXPECT_LT((estimate.T_cam_map.translation() - T_visual.translation()).norm(), 0.005);
  EXPECT_GT(estimate.inliers, 150 * 80 / 100);
}

/// Two points leave a pose open.
TEST_F(PoseSolverTest, CovarianceOfTooFewPointsIsHuge) {
  const PoseCovariance covariance = solver_.covariance(observe(2, false), camera_, T_cam_map_);
  EXPECT_TRUE(covariance.allFinite());
  EXPECT_GT(covariance.trace(), 1.0);
}

TEST_F(PoseSolverTest, AWrongDepthAloneMakesAnOutlier) {
  auto observations = observe(100, true);
  ASSERT_TRUE(solver_.refine(observations, camera_, guess()).isInlier[40]);
  observations[40].keypoint.depth_m += 0.5F;
  EXPECT_FALSE(solver_.refine(observations, camera_, guess()).isInlier[40]);
  observations[40].keypoint.depth_m = 0.0F;
  EXPECT_TRUE(solver_.refine(observations, camera_, guess()).isInlier[40]) << "its pixel is right";
}

TEST_F(PoseSolverTest, IsNotMovedByGrossOutliers) {
  for (const bool withDepth : {true, false}) {
    for (int trial = 0; trial < 10; ++trial) {
      const auto observations = spoil(observe(150, withDepth));
      for (const auto& estimate :
           {solver_.refine(observations, camera_, guess()), solver_.solve(observations, camera_)}) {
        std::vector<PointObservation> good;
        int outliersTaken = 0;
        int goodTaken = 0;
        for (std::size_t i = 0; i < observations.size(); ++i) {
          (i % 3 == 0 ? outliersTaken : goodTaken) += estimate.isInlier[i] ? 1 : 0;
          if (i % 3 != 0) good.push_back(observations[i]);
        }
        EXPECT_LT(squaredError(estimate.T_cam_map, good), 30.0);  // 1 in 20,000 of a perfect solver is above 29
        EXPECT_LE(outliersTaken, 2);
        EXPECT_GE(goodTaken, 85);
        EXPECT_EQ(estimate.inliers, outliersTaken + goodTaken);
      }
    }
  }
}

TEST_F(PoseSolverTest, FindsThePoseFromNothing) {
  for (const int count : {6, 20, 200}) {
    const auto observations = observe(count, true);
    const auto estimate = solver_.solve(observations, camera_);
    EXPECT_LT(squaredError(estimate.T_cam_map, observations), 60.0) << count;
    EXPECT_GE(estimate.inliers, count * 3 / 4);
  }
}

TEST_F(PoseSolverTest, StandsPointsThatTheGuessPutsBehindTheCamera) {
  auto observations = observe(150, true);
  const Eigen::Isometry3d wayAhead = Eigen::Translation3d(0, 0, -1.2) * T_cam_map_;
  const auto isBehind = [&](const PointObservation& o) { return (wayAhead * o.p_map_m).z() < 0; };
  ASSERT_GT(std::count_if(observations.begin(), observations.end(), isBehind), 5);
  for (const auto& start : {guess(), wayAhead}) {
    const auto estimate = solver_.refine(observations, camera_, start);
    EXPECT_TRUE(estimate.T_cam_map.matrix().allFinite());
  }
}

TEST_F(PoseSolverTest, TooFewPointsGiveNoPose) {
  const auto two = solver_.refine(observe(2, true), camera_, guess());
  EXPECT_EQ(two.inliers, 0);
  EXPECT_THAT(two.isInlier, testing::ElementsAre(false, false));
  EXPECT_TRUE(two.T_cam_map.isApprox(guess()));
  EXPECT_EQ(solver_.refine({}, camera_, guess()).inliers, 0);

  EXPECT_EQ(solver_.solve(observe(5, true), camera_).inliers, 0);
  EXPECT_EQ(solver_.solve({}, camera_).inliers, 0);
}

TEST_F(PoseSolverTest, FindsNoPoseWhereNothingAgrees) {
  auto observations = observe(100, true);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  for (auto& [p_map_m, keypoint] : observations) {
    keypoint.undistorted_px = {640.0F * unit(random_), 480.0F * unit(random_)};
    keypoint.depth_m = 0.8F + 3.5F * unit(random_);
  }
  EXPECT_LT(solver_.solve(observations, camera_).inliers, 15);
}

/// Whatever the points: numbers, and inliers that are counted right.
void expectStatus(const PoseEstimate& estimate, std::size_t observations) {
  EXPECT_TRUE(estimate.T_cam_map.matrix().allFinite());
  EXPECT_NEAR(estimate.T_cam_map.linear().determinant(), 1.0, 1e-6);
  EXPECT_EQ(estimate.isInlier.size(), observations);
  EXPECT_EQ(estimate.inliers, std::count(estimate.isInlier.begin(), estimate.isInlier.end(), true));
}

TEST_F(PoseSolverTest, PointsThatTellLittleGiveAStatusAndNoNaN) {
  using Place = std::function<Eigen::Vector3d(double u, double v)>;
  const std::vector<std::pair<const char*, Place>> places = {
      {"one point", [](double, double) { return Eigen::Vector3d(0.1, 0.2, 2.0); }},
      {"a line", [](double u, double) { return Eigen::Vector3d(u, 0.3 * u, 2.0 + 0.5 * u); }},
      {"a line of sight",
       [](double u, double) -> Eigen::Vector3d { return Eigen::Vector3d(0.1, 0.1, 1.0) * (2.0 + u); }},
      {"a plane", [](double u, double v) { return Eigen::Vector3d(u, v, 2.0); }},
      {"a plane seen edge on", [](double u, double v) { return Eigen::Vector3d(u, 0.0, 3.0 + v); }},
      {"the camera's own place", [](double, double) { return Eigen::Vector3d(0.0, 0.0, 0.0); }}};
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (const auto& [name, place] : places) {
    for (const int count : {0, 1, 2, 3, 4, 5, 6, 60}) {
      for (const bool withDepth : {true, false}) {
        SCOPED_TRACE(std::string(name) + ", " + std::to_string(count) + (withDepth ? "" : " without depth"));
        std::vector<PointObservation> observations;
        for (int i = 0; i < count; ++i) {
          const Eigen::Vector3d p_cam_m = place(unit(random_), unit(random_));
          const Eigen::Vector2d px = p_cam_m.z() > 0 ? camera_.project(p_cam_m) : Eigen::Vector2d(320, 240);
          PointObservation observation;
          observation.p_map_m = T_cam_map_.inverse() * p_cam_m;
          observation.keypoint.undistorted_px = {static_cast<float>(px.x()), static_cast<float>(px.y())};
          if (withDepth) observation.keypoint.depth_m = static_cast<float>(p_cam_m.z());
          observations.push_back(observation);
        }
        for (const auto& start : {guess(), T_cam_map_}) {
          expectStatus(solver_.refine(observations, camera_, start), observations.size());
          EXPECT_TRUE(solver_.covariance(observations, camera_, start).allFinite());
        }
        expectStatus(solver_.solve(observations, camera_), observations.size());
      }
    }
  }
}

TEST_F(PoseSolverTest, APureTurnOfTheCameraIsFound) {
  const auto observations = observe(150, true);
  const Eigen::Isometry3d turned = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()) * T_cam_map_;
  EXPECT_LT(squaredError(solver_.refine(observations, camera_, turned).T_cam_map, observations), 60.0);
}

}  // namespace
}  // namespace wardslam::odometry
