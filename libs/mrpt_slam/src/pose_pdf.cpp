#include "pose_pdf.h"

#include <Eigen/LU>
#include <cmath>

#include "wardslam/core/mrpt_compat.h"

namespace wardslam::mrpt_slam {
namespace {

Eigen::Matrix<double, 6, 1> coordinates(const Eigen::Isometry3d& T) {
  const mrpt::poses::CPose3D pose = core::toMrpt(T);
  Eigen::Matrix<double, 6, 1> all;
  all << pose.x(), pose.y(), pose.z(), pose.yaw(), pose.pitch(), pose.roll();
  return all;
}

/// d (x y z yaw pitch roll) / d (translation, rotation vector of the body).
odometry::PoseCovariance jacobian(const Eigen::Isometry3d& T_map_body) {
  constexpr double kStep = 1e-6;
  odometry::PoseCovariance J;
  for (int i = 0; i < 6; ++i) {
    const auto moved = [&](double by) {
      Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
      if (i < 3) {
        motion.translation()[i] = by;
      } else {
        motion.linear() = Eigen::AngleAxisd(by, Eigen::Vector3d::Unit(i - 3)).toRotationMatrix();
      }
      return coordinates(T_map_body * motion);
    };
    Eigen::Matrix<double, 6, 1> difference = moved(kStep) - moved(-kStep);
    for (int angle = 3; angle < 6; ++angle) difference[angle] = std::remainder(difference[angle], 2.0 * M_PI);
    J.col(i) = difference / (2.0 * kStep);
  }
  return J;
}

}  // namespace

odometry::PoseCovariance bodyCovariance(const mrpt::poses::CPose3DPDFGaussian& pdf) {
  const odometry::PoseCovariance back = jacobian(core::fromMrpt(pdf.mean)).inverse();
  return back * pdf.cov.asEigen() * back.transpose();
}

mrpt::poses::CPose3DPDFGaussian toGaussian(const Eigen::Isometry3d& T_map_body,
                                           const odometry::PoseCovariance& covariance) {
  const odometry::PoseCovariance J = jacobian(T_map_body);
  mrpt::poses::CPose3DPDFGaussian pdf{core::toMrpt(T_map_body)};
  pdf.cov.asEigen() = J * covariance * J.transpose();
  return pdf;
}

}  // namespace wardslam::mrpt_slam
