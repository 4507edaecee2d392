#include "wardslam/odometry/pose_solver.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

#include "pose_problem.h"
#include "wardslam/odometry/observation_error.h"

namespace wardslam::odometry {
namespace {

/// Minimises over the observations that `use` selects, then over those that fit.
PoseEstimate refineFrom(Eigen::Isometry3d T_cam_map, std::vector<bool> use, const PoseProblem& problem) {
  for (const bool robust : {true, true, false}) {
    T_cam_map = problem.minimise(T_cam_map, use, robust);
    use = problem.fitting(T_cam_map);
  }
  const auto inliers = static_cast<int>(std::count(use.begin(), use.end(), true));
  return {T_cam_map, std::move(use), inliers};
}

}  // namespace

PoseEstimate PoseSolver::refine(const std::vector<PointObservation>& observations, const core::CameraModel& camera,
                                const Eigen::Isometry3d& T_cam_map_guess, const PosePrior* prior) const {
  if (observations.size() < 3) return {T_cam_map_guess, std::vector<bool>(observations.size(), false), 0};
  const PoseProblem problem(observations, camera, options_, prior);
  return refineFrom(T_cam_map_guess, problem.inFront(T_cam_map_guess), problem);
}

PoseCovariance PoseSolver::covariance(const std::vector<PointObservation>& observations,
                                      const core::CameraModel& camera, const Eigen::Isometry3d& T_cam_map,
                                      const PosePrior* prior) const {
  constexpr double kAlmostNothing = 1e-6;  // of a standard deviation of a kilometre
  PoseCovariance information = kAlmostNothing * PoseCovariance::Identity();
  if (prior != nullptr) information += prior->covariance.inverse();
  information += PoseProblem(observations, camera, options_, nullptr).information(T_cam_map);
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
  const Eigen::Isometry3d T_cam_map = toIsometry(pose);
  const PoseProblem problem(observations, camera, options_, nullptr);
  // Where most matches are wrong, they would pull the pose away together, robust loss or not.
  const std::vector<bool> isInFront = problem.inFront(T_cam_map);
  std::vector<bool> use(observations.size(), false);
  for (const int i : agreeing) {
    const auto index = static_cast<std::size_t>(i);
    use[index] = isInFront[index];
  }
  return refineFrom(T_cam_map, std::move(use), problem);
}

}  // namespace wardslam::odometry
