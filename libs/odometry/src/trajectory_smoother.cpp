#include "wardslam/odometry/trajectory_smoother.h"

#include <ceres/ceres.h>
#include <ceres/normal_prior.h>
#include <ceres/rotation.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "twist.h"

namespace wardslam::odometry {
namespace {

constexpr double kLeast_s = 1e-4;      // between two images
constexpr double kTiny = 1e-4;         // m and rad: a covariance of nothing has no inverse
constexpr std::size_t kWindow = 1000;  // poses solved for at once,
constexpr std::size_t kMargin = 100;   // and on either side for what they say of these
constexpr int kMostIterations = 20;

using Poses = std::vector<EstimatedPose>;
using Range = std::pair<std::size_t, std::size_t>;  // [first, behind the last)

/// A small motion (translation, rotation vector) in the camera's frame, as PoseCovariance has it.
using Motion = std::array<double, 6>;

template <class T>
struct MovedPose {
  std::array<T, 3> p_map_m;
  std::array<T, 4> q_map_cam;  // w, x, y, z

  MovedPose(const Eigen::Isometry3d& from, const T* motion) {
    for (int row = 0; row < 3; ++row) {
      p_map_m[static_cast<std::size_t>(row)] = T(from.translation()[row]) + from.linear()(row, 0) * motion[0] +
                                               from.linear()(row, 1) * motion[1] + from.linear()(row, 2) * motion[2];
    }
    const Eigen::Quaterniond q(from.linear());
    const T before[4] = {T(q.w()), T(q.x()), T(q.y()), T(q.z())};
    T turn[4];
    ceres::AngleAxisToQuaternion(motion + 3, turn);
    ceres::QuaternionProduct(before, turn, q_map_cam.data());
  }
};

/// From one pose to the next, per second.
template <class T>
std::array<T, 6> velocity(const MovedPose<T>& from, const MovedPose<T>& to, double seconds) {
  const T back[4] = {from.q_map_cam[0], -from.q_map_cam[1], -from.q_map_cam[2], -from.q_map_cam[3]};
  T turn[4];
  ceres::QuaternionProduct(back, to.q_map_cam.data(), turn);
  std::array<T, 6> velocity;
  ceres::QuaternionToAngleAxis(turn, velocity.data() + 3);
  for (std::size_t i = 0; i < 3; ++i) {
    velocity[i] = (to.p_map_m[i] - from.p_map_m[i]) / seconds;
    velocity[3 + i] /= seconds;
  }
  return velocity;
}

/// By how much two mean velocities differ, of times that follow each other: white noise of acceleration lets the
/// difference grow by a third of both times.
struct VelocityChange {
  std::array<Eigen::Isometry3d, 3> T_map_cam;
  std::array<double, 2> seconds;
  SmoothingOptions options;

  template <class T>
  bool operator()(const T* first, const T* second, const T* third, T* residual) const {
    const MovedPose<T> a(T_map_cam[0], first);
    const MovedPose<T> b(T_map_cam[1], second);
    const MovedPose<T> c(T_map_cam[2], third);
    const auto before = velocity(a, b, seconds[0]);
    const auto after = velocity(b, c, seconds[1]);
    const double root_s = std::sqrt((seconds[0] + seconds[1]) / 3.0);
    for (std::size_t i = 0; i < 6; ++i) {
      residual[i] =
          (after[i] - before[i]) / (root_s * (i < 3 ? options.velocity_change_mps : options.turn_change_radps));
    }
    return true;
  }
};

ceres::CostFunction* measurement(PoseCovariance covariance, double leastSigma_m) {
  covariance.diagonal().array() += kTiny * kTiny;
  covariance.diagonal().head<3>().array() += leastSigma_m * leastSigma_m;
  const PoseCovariance information = covariance.inverse();
  const Eigen::LLT<PoseCovariance> root(information);
  return new ceres::NormalPrior(ceres::Matrix(PoseCovariance(root.matrixU())), ceres::Vector(ceres::Vector::Zero(6)));
}

double secondsBetween(const EstimatedPose& a, const EstimatedPose& b) {
  return std::max(kLeast_s, b.stamp_s - a.stamp_s);
}

/// The likeliest small motions of these poses.
std::vector<Motion> likeliestMotions(const Poses& poses, const Range& range, const SmoothingOptions& options) {
  const auto [first, end] = range;
  std::vector<Motion> motions(end - first, Motion{});
  ceres::Problem problem;
  for (std::size_t i = first; i < end; ++i) {
    problem.AddParameterBlock(motions[i - first].data(), 6);
    if (poses[i].isExact()) problem.SetParameterBlockConstant(motions[i - first].data());
    if (poses[i].covariance) {
      problem.AddResidualBlock(measurement(*poses[i].covariance, options.least_sigma_m), nullptr,
                               motions[i - first].data());
    }
    if (i < first + 2) continue;
    auto* const change =
        new VelocityChange{{poses[i - 2].T_map_cam, poses[i - 1].T_map_cam, poses[i].T_map_cam},
                           {secondsBetween(poses[i - 2], poses[i - 1]), secondsBetween(poses[i - 1], poses[i])},
                           options};
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<VelocityChange, 6, 6, 6, 6>(change), nullptr,
                             motions[i - 2 - first].data(), motions[i - 1 - first].data(), motions[i - first].data());
  }
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  solver.max_num_iterations = kMostIterations;
  solver.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  if (!summary.IsSolutionUsable()) return std::vector<Motion>(end - first, Motion{});
  return motions;
}

Eigen::Isometry3d moved(const Eigen::Isometry3d& T_map_cam, const Motion& motion) {
  return T_map_cam * after({{motion[0], motion[1], motion[2]}, {motion[3], motion[4], motion[5]}}, 1.0);
}

/// Poses that nobody told begin on the straight way between those that somebody did.
void placeOnTheWay(Poses& poses, const Range& range) {
  for (std::size_t i = range.first + 1; i + 1 < range.second; ++i) {
    if (poses[i].isKnown()) continue;
    std::size_t next = i + 1;
    while (!poses[next].isKnown()) ++next;  // the last of a range is seen
    const double share = secondsBetween(poses[i - 1], poses[i]) / secondsBetween(poses[i - 1], poses[next]);
    const Eigen::Isometry3d& a = poses[i - 1].T_map_cam;
    const Eigen::Isometry3d& b = poses[next].T_map_cam;
    poses[i].T_map_cam.translation() = a.translation() + share * (b.translation() - a.translation());
    poses[i].T_map_cam.linear() =
        Eigen::Quaterniond(a.linear()).slerp(share, Eigen::Quaterniond(b.linear())).toRotationMatrix();
  }
}

/// From one that is seen to another one, without a longer gap in between.
std::vector<Range> stretchesOf(const Poses& poses, double longestGap_s) {
  std::vector<Range> stretches;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!poses[i].isSeen) continue;
    const bool goesOn =
        !stretches.empty() && poses[i].stamp_s - poses[stretches.back().second - 1].stamp_s <= longestGap_s;
    if (goesOn) {
      stretches.back().second = i + 1;
    } else {
      stretches.emplace_back(i, i + 1);
    }
  }
  return stretches;
}

void smooth(Poses& poses, const Range& stretch, const SmoothingOptions& options) {
  const Poses measured = poses;
  for (std::size_t first = stretch.first; first < stretch.second; first += kWindow) {
    const Range core{first, std::min(stretch.second, first + kWindow)};
    const Range window{std::max(stretch.first + kMargin, core.first) - kMargin,
                       std::min(stretch.second, core.second + kMargin)};
    const auto motions = likeliestMotions(measured, window, options);
    for (std::size_t i = core.first; i < core.second; ++i) {
      poses[i].T_map_cam = moved(measured[i].T_map_cam, motions[i - window.first]);
    }
  }
}

}  // namespace

core::Trajectory smoothed(const std::vector<EstimatedPose>& estimated, const SmoothingOptions& options) {
  Poses poses = estimated;
  core::Trajectory trajectory;
  for (const Range& stretch : stretchesOf(poses, options.longest_bridge_s)) {
    placeOnTheWay(poses, stretch);
    if (options.velocity_change_mps > 0.0) smooth(poses, stretch, options);
    for (std::size_t i = stretch.first; i < stretch.second; ++i) {
      trajectory.push_back({poses[i].stamp_s, poses[i].T_map_cam, !poses[i].isSeen});
    }
  }
  return trajectory;
}

}  // namespace wardslam::odometry
