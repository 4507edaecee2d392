#include "motion_of_actions.h"

#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/poses/CPosePDFGaussian.h>

#include "pose_pdf.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::mrpt_slam {
namespace {

using mrpt::obs::CActionRobotMovement2D;
using mrpt::obs::CActionRobotMovement3D;

constexpr double kLift_m = 0.005;
constexpr double kTilt_rad = 0.01;
constexpr double kSurest_m = 1e-4;
constexpr double kSurest_rad = 1e-4;

odometry::MotionPrior requireUsable(odometry::MotionPrior motion) {
  motion.covariance.diagonal().head<3>().array() += kSurest_m * kSurest_m;
  motion.covariance.diagonal().tail<3>().array() += kSurest_rad * kSurest_rad;
  if (odometry::isUsable(motion)) return motion;
  throw core::InputError(
      "the odometry of an action is no motion: its numbers must be finite, and its covariance positive; give none "
      "where the wheels say nothing");
}

/// `covariance`: x, y (m), yaw (rad).
odometry::MotionPrior planar(const mrpt::poses::CPose2D& motion, const mrpt::math::CMatrixDouble33& covariance) {
  mrpt::poses::CPose3DPDFGaussian pdf{mrpt::poses::CPose3D(motion)};
  pdf.cov.setZero();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      pdf.cov(row == 2 ? 3 : row, column == 2 ? 3 : column) = covariance(row, column);
    }
  }
  pdf.cov(2, 2) = kLift_m * kLift_m;
  pdf.cov(4, 4) = pdf.cov(5, 5) = kTilt_rad * kTilt_rad;
  return requireUsable({core::fromMrpt(pdf.mean), bodyCovariance(pdf)});
}

}  // namespace

std::optional<odometry::MotionPrior> motionOf(const mrpt::obs::CActionCollection& actions) {
  if (const auto spatial = actions.getActionByClass<CActionRobotMovement3D>()) {
    return requireUsable({core::fromMrpt(spatial->poseChange.mean), bodyCovariance(spatial->poseChange)});
  }
  const auto onFloor = actions.getBestMovementEstimation();
  if (!onFloor || !onFloor->poseChange) return std::nullopt;
  mrpt::poses::CPosePDFGaussian gaussian;
  gaussian.copyFrom(*onFloor->poseChange);
  return planar(gaussian.mean, gaussian.cov);
}

void OdometerMotion::add(const mrpt::obs::CObservationOdometry& reading) {
  const double stamp_s = core::fromMrptTime(reading.timestamp);
  if (last_ && stamp_s <= last_->stamp_s) return;
  before_ = last_;
  last_ = Reading{stamp_s, reading.odometry};
}

std::optional<odometry::MotionPrior> OdometerMotion::between(double from_s, double to_s) const {
  if (!before_) return std::nullopt;
  const double period_s = last_->stamp_s - before_->stamp_s;
  if (to_s - last_->stamp_s > period_s || to_s <= from_s) return std::nullopt;
  const double share = (to_s - from_s) / period_s;
  const mrpt::poses::CPose2D way = last_->pose - before_->pose;
  CActionRobotMovement2D action;
  CActionRobotMovement2D::TMotionModelOptions model;
  model.modelSelection = CActionRobotMovement2D::mmGaussian;
  action.computeFromOdometry({share * way.x(), share * way.y(), share * way.phi()}, model);
  mrpt::poses::CPosePDFGaussian gaussian;
  gaussian.copyFrom(*action.poseChange);
  return planar(gaussian.mean, gaussian.cov);
}

}  // namespace wardslam::mrpt_slam
