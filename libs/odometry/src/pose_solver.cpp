#include "wardslam/odometry/pose_solver.h"
#include "wardslam/core/rotation_vector.h"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

#include "wardslam/odometry/observation_error.h"

namespace wardslam::odometry {
namespace {

/// ObservationError of a point that is not moved.
struct PoseError {
  ObservationError error;
  Eigen::Vector3d p_map_m;

  template <class T>
  bool operator()(const T* pose, T* residual) const {
    const Eigen::Matrix<T, 3, 1> p_map = p_map_m.cast<T>();
    return error(pose, p_map.data(), residual);
  }
};

/// Where the camera is in the frame of the camera where it ought to be, in units of the standard deviation.
struct PriorError {
  explicit PriorError(const PosePrior& prior)
      : predicted(toPoseVector(prior.T_cam_map)),
        squareRootInformation(Eigen::LLT<PoseCovariance>(prior.covariance.inverse()).matrixU()) {}

  template <class T>
  bool operator()(const T* pose, T* residual) const {
    using Vector3 = Eigen::Matrix<T, 3, 1>;
    const Vector3 turnBack(-pose[0], -pose[1], -pose[2]);
    const Eigen::Matrix<T, 6, 1> from = predicted.cast<T>();
    T q_map_cam[4];
    T q_predicted_map[4];
    T q_predicted_cam[4];
    ceres::AngleAxisToQuaternion(turnBack.data(), q_map_cam);
    ceres::AngleAxisToQuaternion(from.data(), q_predicted_map);
    ceres::QuaternionProduct(q_predicted_map, q_map_cam, q_predicted_cam);
    Vector3 turned;
    ceres::QuaternionRotatePoint(q_predicted_cam, pose + 3, turned.data());
    Eigen::Matrix<T, 6, 1> error;
    error.template head<3>() = from.template tail<3>() - turned;
    ceres::QuaternionToAngleAxis(q_predicted_cam, error.data() + 3);
    Eigen::Map<Eigen::Matrix<T, 6, 1>> weighted(residual);
    weighted = squareRootInformation.cast<T>() * error;
    return true;
  }

  PoseVector predicted;
  PoseCovariance squareRootInformation;
};

/// 95 % of motions that are as sure as said have a smaller squared error (chi-square, 6 degrees of freedom).
constexpr double kChiSquareOfPrior = 12.592;

class ErrorModel {
 public:
  ErrorModel(const PoseSolverOptions& options, const core::CameraModel& camera) : options_(options), camera_(camera) {}

  [[nodiscard]] ceres::CostFunction* cost(const PointObservation& observation) const {
    auto* functor = new PoseError{error(observation), observation.p_map_m};
    if (observation.keypoint.hasDepth()) return new ceres::AutoDiffCostFunction<PoseError, 3, 6>(functor);
    return new ceres::AutoDiffCostFunction<PoseError, 2, 6>(functor);
  }

  [[nodiscard]] bool isInlier(const PointObservation& observation, const PoseVector& pose) const {
    return error(observation).squared(pose, observation.p_map_m) < chiSquareOf(observation.keypoint);
  }

  [[nodiscard]] bool isInFront(const PointObservation& observation, const PoseVector& pose) const {
    return std::isfinite(error(observation).squared(pose, observation.p_map_m));
  }

 private:
  [[nodiscard]] ObservationError error(const PointObservation& observation) const {
    return {observation.keypoint, camera_, options_.pixel_sigma_px, options_.depth_sigma_scale};
  }

  const PoseSolverOptions& options_;
  const core::CameraModel& camera_;
};

/// d (measurement in units of its standard deviation) / d (translation, rotation vector of the camera's own motion).
Eigen::Matrix<double, 3, 6> jacobian(const PointObservation& observation, const core::CameraModel& camera,
                                     const PoseSolverOptions& options, const Eigen::Vector3d& p_cam_m) {
  const core::Keypoint& keypoint = observation.keypoint;
  const double sigma_px = options.pixel_sigma_px * static_cast<double>(keypoint.scale);
  const double z_m = p_cam_m.z();
  Eigen::Matrix3d ofPoint;
  ofPoint << camera.fx_px / z_m / sigma_px, 0.0, -camera.fx_px * p_cam_m.x() / (z_m * z_m) / sigma_px,  //
      0.0, camera.fy_px / z_m / sigma_px, -camera.fy_px * p_cam_m.y() / (z_m * z_m) / sigma_px,         //
      0.0, 0.0,
      keypoint.hasDepth() ? 1.0 / (options.depth_sigma_scale * core::depthSigma_m(keypoint, camera.depthNoise)) : 0.0;
  Eigen::Matrix<double, 3, 6> ofPose;
  ofPose.leftCols<3>() = -Eigen::Matrix3d::Identity();
  ofPose.rightCols<3>() = core::crossProductWith(p_cam_m);
  return ofPoint * ofPose;
}

/// Least squares over the observations that `use` selects; `robust` bends the cost of large errors (Huber).
void minimise(const std::vector<PointObservation>& observations, const std::vector<bool>& use, bool robust,
              const ErrorModel& model, int maxIterations, const PosePrior* prior, PoseVector& pose) {
  ceres::Problem problem;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    if (!use[i]) continue;
    const core::Keypoint& keypoint = observations[i].keypoint;
    auto* loss = robust ? new ceres::HuberLoss(std::sqrt(chiSquareOf(keypoint))) : nullptr;
    problem.AddResidualBlock(model.cost(observations[i]), weightedLoss(loss, keypoint), pose.data());
  }
  if (problem.NumResidualBlocks() < 3) return;
  if (prior != nullptr) {
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<PriorError, 6, 6>(new PriorError(*prior)),
                             new ceres::HuberLoss(std::sqrt(kChiSquareOfPrior)), pose.data());
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = maxIterations;
  options.function_tolerance = 1e-6;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
}

/// Minimises over the observations that `use` selects, then over those that fit.
PoseEstimate refineFrom(PoseVector pose, std::vector<bool> use, const std::vector<PointObservation>& observations,
                        const ErrorModel& model, int maxIterations, const PosePrior* prior = nullptr) {
  for (const bool robust : {true, true, false}) {
    minimise(observations, use, robust, model, maxIterations, prior, pose);
    for (std::size_t i = 0; i < observations.size(); ++i) use[i] = model.isInlier(observations[i], pose);
  }
  const auto inliers = static_cast<int>(std::count(use.begin(), use.end(), true));
  return {toIsometry(pose), std::move(use), inliers};
}

}  // namespace

PoseEstimate PoseSolver::refine(const std::vector<PointObservation>& observations, const core::CameraModel& camera,
                                const Eigen::Isometry3d& T_cam_map_guess, const PosePrior* prior) const {
  if (observations.size() < 3) return {T_cam_map_guess, std::vector<bool>(observations.size(), false), 0};
  const ErrorModel model(options_, camera);
  const PoseVector pose = toPoseVector(T_cam_map_guess);
  std::vector<bool> use;
  for (const auto& observation : observations) use.push_back(model.isInFront(observation, pose));
  return refineFrom(pose, std::move(use), observations, model, options_.max_iterations, prior);
}

PoseCovariance PoseSolver::covariance(const std::vector<PointObservation>& observations,
                                      const core::CameraModel& camera, const Eigen::Isometry3d& T_cam_map,
                                      const PosePrior* prior) const {
  constexpr double kAlmostNothing = 1e-6;  // of a standard deviation of a kilometre
  PoseCovariance information = kAlmostNothing * PoseCovariance::Identity();
  if (prior != nullptr) information += prior->covariance.inverse();
  for (const PointObservation& observation : observations) {
    const Eigen::Vector3d p_cam_m = T_cam_map * observation.p_map_m;
    if (p_cam_m.z() < 0.01) continue;
    const auto J = jacobian(observation, camera, options_, p_cam_m);
    information += static_cast<double>(observation.keypoint.staticProbability) * J.transpose() * J;
  }
  return information.inverse();
}

PoseEstimate PoseSolver::solve(const std::vector<PointObservation>& observations,
                               const core::CameraModel& camera) const {
  constexpr int kIterations = 1000;
  constexpr float kInlierDistance_px = 5.0F;
  constexpr std::size_t kMinObservations = 6;
  PoseEstimate none;
  none.isInlier.assign(observations.size(), false);
  if (observations.size() < kMinObservations) return none;

  std::vector<cv::Point3d> points_map;
  std::vector<cv::Point2d> pixels;
  for (const auto& observation : observations) {
    points_map.emplace_back(observation.p_map_m.x(), observation.p_map_m.y(), observation.p_map_m.z());
    pixels.emplace_back(observation.keypoint.undistorted_px);
  }
  const cv::Matx33d K(camera.fx_px, 0, camera.cx_px, 0, camera.fy_px, camera.cy_px, 0, 0, 1);
  cv::Vec3d rotation;
  cv::Vec3d translation;
  std::vector<int> agreeing;
  if (!cv::solvePnPRansac(points_map, pixels, K, cv::noArray(), rotation, translation, false, kIterations,
                          kInlierDistance_px, 0.99, agreeing, cv::SOLVEPNP_P3P)) {
    return none;
  }
  PoseVector pose;
  for (int i = 0; i < 3; ++i) {
    pose[i] = rotation[i];
    pose[3 + i] = translation[i];
  }
  // Where most matches are wrong, they would pull the pose away together, robust loss or not.
  const ErrorModel model(options_, camera);
  std::vector<bool> use(observations.size(), false);
  for (const int i : agreeing) {
    const auto index = static_cast<std::size_t>(i);
    use[index] = model.isInFront(observations[index], pose);
  }
  return refineFrom(pose, std::move(use), observations, model, options_.max_iterations);
}

}  // namespace wardslam::odometry
