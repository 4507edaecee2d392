#include "wardslam/odometry/motion_prior.h"
#include "wardslam/core/rotation_vector.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "wardslam/core/rigid_transform.h"

namespace wardslam::odometry {
namespace {

/// How a small motion (translation, rotation vector) of frame a looks in frame b of the same body.
PoseCovariance adjoint(const Eigen::Isometry3d& T_b_a) {
  const Eigen::Matrix3d R = T_b_a.linear();
  PoseCovariance adjoint = PoseCovariance::Zero();
  adjoint.topLeftCorner<3, 3>() = R;
  adjoint.topRightCorner<3, 3>() = core::crossProductWith(T_b_a.translation()) * R;
  adjoint.bottomRightCorner<3, 3>() = R;
  return adjoint;
}

}  // namespace

double worstSigma_m(const PoseCovariance& covariance) { return std::sqrt(covariance.diagonal().head<3>().maxCoeff()); }

double addedSigma_m(const PoseCovariance& before, const PoseCovariance& now) {
  const double was_m = worstSigma_m(before);
  const double is_m = worstSigma_m(now);
  return std::sqrt(std::max(0.0, is_m * is_m - was_m * was_m));
}

PoseCovariance transformed(const PoseCovariance& ofA, const Eigen::Isometry3d& T_a_b) {
  const PoseCovariance change = adjoint(T_a_b.inverse());
  return change * ofA * change.transpose();
}

MotionPrior transformed(const MotionPrior& ofA, const Eigen::Isometry3d& T_a_b) {
  return {core::rigid(T_a_b.inverse() * ofA.T_previous_now * T_a_b), transformed(ofA.covariance, T_a_b)};
}

MotionPrior composed(const MotionPrior& first, const MotionPrior& second) {
  return {core::rigid(first.T_previous_now * second.T_previous_now),
          transformed(first.covariance, second.T_previous_now) + second.covariance};
}

bool isUsable(const MotionPrior& prior) {
  return prior.T_previous_now.matrix().allFinite() && prior.covariance.allFinite() &&
         Eigen::LLT<PoseCovariance>(prior.covariance).info() == Eigen::Success;
}

}  // namespace wardslam::odometry
