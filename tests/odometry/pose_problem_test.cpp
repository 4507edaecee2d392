#include "pose_problem.h"

#include <ceres/ceres.h>
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "wardslam/core/depth_noise.h"
#include "wardslam/odometry/observation_error.h"

namespace wardslam::odometry {
namespace {

/// ObservationError of a point that is not moved, for Ceres, which works out derivatives by itself.
struct PoseError {
  ObservationError error;
  Eigen::Vector3d p_map_m;

  template <class T>
  bool operator()(const T* pose, T* residual) const {
    const Eigen::Matrix<T, 3, 1> p_map = p_map_m.cast<T>();
    residual[2] = T(0);
    return error(pose, p_map.data(), residual);
  }
};

/// Where the camera is in the frame of the camera where it ought to be.
struct PriorError {
  PosePrior prior;

  template <class T>
  bool operator()(const T* pose, T* residual) const {
    Eigen::Matrix<T, 3, 3> R_cam_map;
    ceres::AngleAxisToRotationMatrix(pose, R_cam_map.data());
    const Eigen::Matrix<T, 3, 1> t_cam(pose[3], pose[4], pose[5]);
    const Eigen::Matrix<T, 3, 3> R = prior.T_cam_map.linear().cast<T>() * R_cam_map.transpose();
    Eigen::Matrix<T, 6, 1> error;
    error.template head<3>() = prior.T_cam_map.translation().cast<T>() - R * t_cam;
    ceres::RotationMatrixToAngleAxis(R.data(), error.data() + 3);
    const PoseCovariance U = Eigen::LLT<PoseCovariance>(prior.covariance.inverse()).matrixU();
    Eigen::Map<Eigen::Matrix<T, 6, 1>> weighted(residual);
    weighted = U.cast<T>() * error;
    return true;
  }
};

class PoseProblemTest : public ::testing::Test {
 protected:
  PoseProblemTest() {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 120; ++i) {
      const double z_m = 0.8 + 3.5 * unit(random_);
      const Eigen::Vector3d p_cam_m = camera_.unproject({640 * unit(random_), 480 * unit(random_)}, z_m);
      const double off = i % 6 == 0 ? 15.0 : 1.0;  // some are wrong by far
      const Eigen::Vector2d px = camera_.project(p_cam_m) + off * Eigen::Vector2d(normal(random_), normal(random_));
      PointObservation observation;
      observation.p_map_m = T_cam_map_.inverse() * p_cam_m;
      observation.keypoint.undistorted_px = {static_cast<float>(px.x()), static_cast<float>(px.y())};
      observation.keypoint.scale = i % 2 == 0 ? 1.2F : 1.0F;
      if (i % 3 > 0)
        observation.keypoint.depth_m = static_cast<float>(z_m + core::DepthNoise().sigma_m(z_m) * normal(random_));
      if (i % 5 == 0) observation.keypoint.staticProbability = 0.4F;
      observations_.push_back(observation);
    }
    prior_.T_cam_map = Eigen::Translation3d(0.01, 0.0, -0.02) *
                       Eigen::AngleAxisd(0.02, Eigen::Vector3d(1, -2, 1).normalized()) * T_cam_map_;
    prior_.covariance = PoseCovariance::Identity() * 1e-5;
    prior_.covariance(3, 3) = 1e-3;  // directions differ
    prior_.covariance(0, 4) = prior_.covariance(4, 0) = 4e-6;
  }

  [[nodiscard]] Eigen::Isometry3d byCeres(bool robust, const PosePrior* prior) const {
    PoseVector pose = toPoseVector(guess());
    ceres::Problem problem;
    for (const auto& [p_map_m, keypoint] : observations_) {
      auto* cost = new ceres::AutoDiffCostFunction<PoseError, 3, 6>(new PoseError{
          ObservationError(keypoint, camera_, options_.pixel_sigma_px, options_.depth_sigma_scale), p_map_m});
      auto* loss = robust ? new ceres::HuberLoss(std::sqrt(chiSquareOf(keypoint))) : nullptr;
      problem.AddResidualBlock(cost, weightedLoss(loss, keypoint), pose.data());
    }
    if (prior != nullptr) {
      problem.AddResidualBlock(new ceres::AutoDiffCostFunction<PriorError, 6, 6>(new PriorError{*prior}),
                               new ceres::HuberLoss(std::sqrt(12.592)), pose.data());
    }
    ceres::Solver::Options options;
    options.max_num_iterations = 200;
    options.function_tolerance = options.parameter_tolerance = options.gradient_tolerance = 1e-15;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    return toIsometry(pose);
  }

  [[nodiscard]] Eigen::Isometry3d byUs(bool robust, const PosePrior* prior) const {
    PoseSolverOptions patient = options_;
    patient.max_iterations = 100;
    return PoseProblem(observations_, camera_, patient, prior)
        .minimise(guess(), std::vector<bool>(observations_.size(), true), robust);
  }

  [[nodiscard]] Eigen::Isometry3d guess() const {
    return Eigen::Translation3d(0.03, -0.04, 0.0) * Eigen::AngleAxisd(0.05, Eigen::Vector3d(1, 1, 1).normalized()) *
           T_cam_map_;
  }

  const core::CameraModel camera_;
  const PoseSolverOptions options_;
  const Eigen::Isometry3d T_cam_map_ =
      Eigen::Translation3d(0.4, -0.2, 0.7) * Eigen::AngleAxisd(0.6, Eigen::Vector3d(0.3, 1.0, -0.2).normalized());
  std::mt19937 random_{3};
  std::vector<PointObservation> observations_;
  PosePrior prior_;
};

TEST_F(PoseProblemTest, FindsTheMinimumThatCeresFinds) {
  for (const PosePrior* prior : {static_cast<const PosePrior*>(nullptr), static_cast<const PosePrior*>(&prior_)}) {
    for (const bool robust : {false, true}) {
      const Eigen::Isometry3d off = byUs(robust, prior) * byCeres(robust, prior).inverse();
      EXPECT_LT(off.translation().norm(), 2e-7) << robust << (prior != nullptr);
      EXPECT_LT(Eigen::AngleAxisd(off.linear()).angle(), 1e-7) << robust << (prior != nullptr);
    }
  }
  const Eigen::Isometry3d T_prior = byUs(true, &prior_) * byUs(true, nullptr).inverse();
  EXPECT_GT(T_prior.translation().norm(), 1e-4) << "the prior has a say in it";
}

TEST_F(PoseProblemTest, APriorFarOffPullsNoHarder) {
  prior_.T_cam_map =
      Eigen::Translation3d(0.3, 0.0, 0.0) * Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitX()) * T_cam_map_;
  const Eigen::Isometry3d off = byUs(true, &prior_) * byCeres(true, &prior_).inverse();
  EXPECT_LT(off.translation().norm(), 2e-7);
}

TEST_F(PoseProblemTest, OfTwoPointsThePoseStaysAsGuessed) {
  std::vector<bool> two(observations_.size(), false);
  two[0] = two[1] = true;
  EXPECT_TRUE(
      PoseProblem(observations_, camera_, options_, nullptr).minimise(guess(), two, true).isApprox(guess(), 1e-12));
}

TEST_F(PoseProblemTest, TellsWhatFitsAndWhatIsInFront) {
  const PoseProblem problem(observations_, camera_, options_, nullptr);
  const auto fits = problem.fitting(T_cam_map_);
  EXPECT_GT(std::count(fits.begin(), fits.end(), true), 120 * 5 / 6 * 88 / 100);
  EXPECT_LT(std::count(fits.begin(), fits.end(), true), 120 * 5 / 6 + 4);
  const auto behind = problem.inFront(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitY()) * T_cam_map_);
  EXPECT_EQ(std::count(behind.begin(), behind.end(), true), 0);
}

}  // namespace
}  // namespace wardslam::odometry
