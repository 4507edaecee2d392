#include "wardslam/core/ground_plane.h"

#include <algorithm>
#include <cmath>

namespace wardslam::core {

double GroundPlane::sigmaOf_m(const Eigen::Vector3d& p_cam_m) const {
  Eigen::Vector3d jacobian;
  jacobian << tangents().transpose() * p_cam_m, 1.0;
  return std::sqrt(std::max(0.0, jacobian.dot(covariance * jacobian)));
}

Eigen::Matrix<double, 3, 2> GroundPlane::tangents() const {
  Eigen::Matrix<double, 3, 2> tangents;
  tangents.col(0) = normal_cam.unitOrthogonal();
  tangents.col(1) = normal_cam.cross(tangents.col(0));
  return tangents;
}

Eigen::Isometry3d GroundPlane::T_ground_cam() const {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::Quaterniond::FromTwoVectors(normal_cam, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T.translation().z() = height_m;
  return T;
}

GroundPlane GroundPlane::atZero(const Eigen::Isometry3d& T_level_cam) {
  GroundPlane plane;
  plane.normal_cam = T_level_cam.linear().transpose() * Eigen::Vector3d::UnitZ();
  plane.height_m = T_level_cam.translation().z();
  return plane;
}

GroundPlane GroundPlane::seenFrom(const Eigen::Isometry3d& T_other_cam) const {
  GroundPlane seen;
  seen.normal_cam = T_other_cam.linear() * normal_cam;
  seen.height_m = height_m - seen.normal_cam.dot(T_other_cam.translation());
  // Both cameras' tangents, as vectors of one frame; the height there is what the plane was not sure of at that place.
  const Eigen::Matrix2d turn = seen.tangents().transpose() * T_other_cam.linear() * tangents();
  const Eigen::Vector3d other_cam_m = T_other_cam.inverse().translation();
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Identity();
  jacobian.topLeftCorner<2, 2>() = turn;
  jacobian.bottomLeftCorner<1, 2>() = (tangents().transpose() * other_cam_m).transpose();
  seen.covariance = jacobian * covariance * jacobian.transpose();
  return seen;
}

}  // namespace wardslam::core
