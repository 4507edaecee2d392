#include "rigid_fit.h"

#include <algorithm>
#include <cmath>

#include "wardslam/core/rigid_transform.h"
#include "wardslam/core/rotation_vector.h"

namespace wardslam::merging {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr int kIterations = 30;
constexpr double kConverged = 1e-12;
constexpr double kKernel = 3.0;  // standard deviations

/// How far the pair is off, in the first map's axes, and how that changes with a small motion of T_a_b within the first
/// map's frame.
struct Residual {
  Vector6 error;
  Matrix6 jacobian = Matrix6::Identity();
};

Residual residualOf(const PosePair& pair, const Eigen::Isometry3d& T_a_b) {
  const Eigen::Isometry3d T_a_cam = T_a_b * pair.T_b_cam;
  Residual residual;
  residual.error << T_a_cam.translation() - pair.T_a_cam.translation(),
      core::rotationVectorOf(T_a_cam.linear() * pair.T_a_cam.linear().transpose());
  residual.jacobian.topRightCorner<3, 3>() = -core::crossProductWith(T_a_cam.translation());
  return residual;
}

struct NormalEquations {
  Matrix6 information = Matrix6::Zero();
  Vector6 gradient = Vector6::Zero();
  double squares = 0.0;  ///< Sum of squared whitened errors, as they are weighted.
};

NormalEquations normalEquationsOf(const std::vector<PosePair>& pairs, const Eigen::Isometry3d& T_a_b,
                                  const graph::PoseGraphOptions& noise) {
  Vector6 weight;
  weight << Eigen::Vector3d::Constant(std::pow(noise.position_sigma_m, -2)),
      Eigen::Vector3d::Constant(std::pow(noise.rotation_sigma_rad, -2));
  NormalEquations sum;
  for (const PosePair& pair : pairs) {
    const Residual residual = residualOf(pair, T_a_b);
    const double squared = residual.error.dot(weight.cwiseProduct(residual.error));
    const Vector6 robust = weight / (1.0 + squared / (kKernel * kKernel * 6.0));
    sum.information += residual.jacobian.transpose() * robust.asDiagonal() * residual.jacobian;
    sum.gradient += residual.jacobian.transpose() * robust.cwiseProduct(residual.error);
    sum.squares += residual.error.dot(robust.cwiseProduct(residual.error));
  }
  return sum;
}

/// Six of the measured numbers go into the transform itself.
double varianceFactor(double squares, std::size_t pairs) {
  const double freedom = 6.0 * static_cast<double>(pairs) - 6.0;
  return freedom > 0 ? std::max(1.0, squares / freedom) : 1.0;
}

}  // namespace

RigidFit fitRigidly(const std::vector<PosePair>& pairs, const graph::PoseGraphOptions& noise) {
  RigidFit fit;
  fit.T_a_b = pairs.front().T_a_cam * pairs.front().T_b_cam.inverse();
  for (int i = 0; i < kIterations; ++i) {
    const NormalEquations equations = normalEquationsOf(pairs, fit.T_a_b, noise);
    const Vector6 step = -equations.information.ldlt().solve(equations.gradient);
    fit.T_a_b = core::rigid(core::motionBy(step.head<3>(), step.tail<3>()) * fit.T_a_b);
    if (step.norm() < kConverged) break;
  }
  const NormalEquations equations = normalEquationsOf(pairs, fit.T_a_b, noise);
  fit.covariance = equations.information.inverse() * varianceFactor(equations.squares, pairs.size());
  for (const PosePair& pair : pairs) {
    const Vector6 error = residualOf(pair, fit.T_a_b).error;
    fit.misfit_m += error.head<3>().squaredNorm() / static_cast<double>(pairs.size());
    fit.misfit_rad += error.tail<3>().squaredNorm() / static_cast<double>(pairs.size());
  }
  fit.misfit_m = std::sqrt(fit.misfit_m);
  fit.misfit_rad = std::sqrt(fit.misfit_rad);
  return fit;
}

}  // namespace wardslam::merging
