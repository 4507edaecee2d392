#include "wardslam/odometry/pose_solver.h"

#include <ceres/ceres.h>

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

/// Least squares over the observations that `use` selects; `robust` bends the cost of large errors (Huber).
void minimise(const std::vector<PointObservation>& observations, const std::vector<bool>& use, bool robust,
              const ErrorModel& model, int maxIterations, PoseVector& pose) {
  ceres::Problem problem;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    if (!use[i]) continue;
    const core::Keypoint& keypoint = observations[i].keypoint;
    auto* loss = robust ? new ceres::HuberLoss(std::sqrt(chiSquareOf(keypoint))) : nullptr;
    problem.AddResidualBlock(model.cost(observations[i]), weightedLoss(loss, keypoint), pose.data());
  }
  if (problem.NumResidualBlocks() < 3) return;
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
                        const ErrorModel& model, int maxIterations) {
  for (const bool robust : {true, true, false}) {
    minimise(observations, use, robust, model, maxIterations, pose);
    for (std::size_t i = 0; i < observations.size(); ++i) use[i] = model.isInlier(observations[i], pose);
  }
  const auto inliers = static_cast<int>(std::count(use.begin(), use.end(), true));
  return {toIsometry(pose), std::move(use), inliers};
}

}  // namespace

PoseEstimate PoseSolver::refine(const std::vector<PointObservation>& observations, const core::CameraModel& camera,
                                const Eigen::Isometry3d& T_cam_map_guess) const {
  if (observations.size() < 3) return {T_cam_map_guess, std::vector<bool>(observations.size(), false), 0};
  const ErrorModel model(options_, camera);
  const PoseVector pose = toPoseVector(T_cam_map_guess);
  std::vector<bool> use;
  for (const auto& observation : observations) use.push_back(model.isInFront(observation, pose));
  return refineFrom(pose, std::move(use), observations, model, options_.max_iterations);
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
