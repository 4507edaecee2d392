#include "pose_solver.h"

#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <cmath>
#include <memory>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

#include "wardslam/odometry/depth_noise.h"

namespace wardslam::odometry {
namespace {

// 95 % of correct observations have a smaller squared error (chi-square with 2 and 3 degrees of freedom).
constexpr double kChiSquare2 = 5.991;
constexpr double kChiSquare3 = 7.815;

using PoseVector = Eigen::Matrix<double, 6, 1>;  // angle-axis rotation, translation (m) of T_cam_map

PoseVector toVector(const Eigen::Isometry3d& T) {
  const Eigen::AngleAxisd rotation(T.linear());
  PoseVector pose;
  pose << rotation.angle() * rotation.axis(), T.translation();
  return pose;
}

Eigen::Isometry3d toIsometry(const PoseVector& pose) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d rotation = pose.head<3>();
  if (rotation.norm() > 0) T.linear() = Eigen::AngleAxisd(rotation.norm(), rotation.normalized()).toRotationMatrix();
  T.translation() = pose.tail<3>();
  return T;
}

/// Whitened error of one observation: two of reprojection and, with depth, one along the optical axis.
struct ObservationError {
  const PointObservation* observation;
  const core::CameraModel* camera;
  double sigma_px;
  double sigma_depth_m;

  template <class T>
  bool operator()(const T* pose, T* error) const {
    const Eigen::Matrix<T, 3, 1> p_map = observation->p_map_m.cast<T>();
    Eigen::Matrix<T, 3, 1> p_cam;
    ceres::AngleAxisRotatePoint(pose, p_map.data(), p_cam.data());
    p_cam += Eigen::Map<const Eigen::Matrix<T, 3, 1>>(pose + 3);
    if (p_cam.z() < T(0.01)) return false;
    const core::Keypoint& keypoint = observation->keypoint;
    const T u = p_cam.x() / p_cam.z() * camera->fx_px + camera->cx_px;
    const T v = p_cam.y() / p_cam.z() * camera->fy_px + camera->cy_px;
    error[0] = (u - static_cast<double>(keypoint.undistorted_px.x)) / sigma_px;
    error[1] = (v - static_cast<double>(keypoint.undistorted_px.y)) / sigma_px;
    if (keypoint.hasDepth()) error[2] = (p_cam.z() - static_cast<double>(keypoint.depth_m)) / sigma_depth_m;
    return true;
  }
};

class ErrorModel {
 public:
  ErrorModel(const PoseSolverOptions& options, const core::CameraModel& camera) : options_(options), camera_(camera) {}

  [[nodiscard]] ObservationError error(const PointObservation& observation) const {
    const double depth_m = static_cast<double>(observation.keypoint.depth_m);
    return {&observation, &camera_, options_.pixel_sigma_px * static_cast<double>(observation.keypoint.scale),
            options_.depth_sigma_scale * kinectDepthSigma_m(depth_m)};
  }

  [[nodiscard]] bool isInlier(const PointObservation& observation, const PoseVector& pose) const {
    Eigen::Vector3d e = Eigen::Vector3d::Zero();
    if (!error(observation)(pose.data(), e.data())) return false;
    return e.squaredNorm() < (observation.keypoint.hasDepth() ? kChiSquare3 : kChiSquare2);
  }

 private:
  const PoseSolverOptions& options_;
  const core::CameraModel& camera_;
};

ceres::CostFunction* makeCost(const ObservationError& error) {
  auto functor = std::make_unique<ObservationError>(error);
  if (error.observation->keypoint.hasDepth()) {
    return new ceres::AutoDiffCostFunction<ObservationError, 3, 6>(functor.release());
  }
  return new ceres::AutoDiffCostFunction<ObservationError, 2, 6>(functor.release());
}

/// Least squares over the observations that `use` selects; `robust` bends the cost of large errors (Huber).
void minimise(const std::vector<PointObservation>& observations, const std::vector<bool>& use, bool robust,
              const ErrorModel& model, int maxIterations, PoseVector& pose) {
  ceres::Problem problem;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    if (!use[i]) continue;
    const bool hasDepth = observations[i].keypoint.hasDepth();
    auto* loss = robust ? new ceres::HuberLoss(std::sqrt(hasDepth ? kChiSquare3 : kChiSquare2)) : nullptr;
    problem.AddResidualBlock(makeCost(model.error(observations[i])), loss, pose.data());
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

}  // namespace

PoseEstimate PoseSolver::refine(const std::vector<PointObservation>& observations, const core::CameraModel& camera,
                                const Eigen::Isometry3d& T_cam_map_guess) const {
  PoseEstimate estimate;
  estimate.T_cam_map = T_cam_map_guess;
  estimate.isInlier.assign(observations.size(), false);
  if (observations.size() < 3) return estimate;

  const ErrorModel model(options_, camera);
  PoseVector pose = toVector(T_cam_map_guess);
  std::vector<bool> use(observations.size(), true);
  for (const bool robust : {true, true, false}) {
    minimise(observations, use, robust, model, options_.max_iterations, pose);
    for (std::size_t i = 0; i < observations.size(); ++i) use[i] = model.isInlier(observations[i], pose);
  }
  estimate.T_cam_map = toIsometry(pose);
  estimate.isInlier = use;
  estimate.inliers = static_cast<int>(std::count(use.begin(), use.end(), true));
  return estimate;
}

PoseEstimate PoseSolver::solve(const std::vector<PointObservation>& observations,
                               const core::CameraModel& camera) const {
  constexpr int kIterations = 200;
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
  if (!cv::solvePnPRansac(points_map, pixels, K, cv::noArray(), rotation, translation, false, kIterations,
                          kInlierDistance_px, 0.99, cv::noArray(), cv::SOLVEPNP_P3P)) {
    return none;
  }
  PoseVector pose;
  for (int i = 0; i < 3; ++i) {
    pose[i] = rotation[i];
    pose[3 + i] = translation[i];
  }
  return refine(observations, camera, toIsometry(pose));
}

}  // namespace wardslam::odometry
