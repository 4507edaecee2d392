#include "wardslam/odometry/map_point.h"

namespace wardslam::odometry {
namespace {

constexpr double kMinViewCosine = 0.5;  // ORB tells little beyond 60 degrees of turning
constexpr double kMinDepth_m = 0.1;

/// Inverse covariance, in the map frame, of the point that a key point with depth measures.
Eigen::Matrix3d measurementInformation(const core::Keypoint& keypoint, const core::CameraModel& camera,
                                       const Eigen::Matrix3d& R_map_cam) {
  const double z_m = keypoint.depth_m;
  const double sigma_z_m = core::depthSigma_m(keypoint, camera.depthNoise);
  const double sigma_xy_m = z_m / camera.fx_px * static_cast<double>(keypoint.scale);
  Eigen::Matrix3d J = Eigen::Matrix3d::Identity();  // d p_cam / d (x and y across the ray, z along the axis)
  J.col(2) = camera.unproject({keypoint.undistorted_px.x, keypoint.undistorted_px.y}, 1.0);
  const Eigen::Vector3d variance(sigma_xy_m * sigma_xy_m, sigma_xy_m * sigma_xy_m, sigma_z_m * sigma_z_m);
  const Eigen::Matrix3d covariance_cam = J * variance.asDiagonal() * J.transpose();
  return R_map_cam * covariance_cam.inverse() * R_map_cam.transpose();
}

Eigen::Vector3d measuredPoint_map(const core::Keypoint& keypoint, const core::CameraModel& camera,
                                  const Eigen::Isometry3d& T_map_cam) {
  const Eigen::Vector2d undistorted_px(keypoint.undistorted_px.x, keypoint.undistorted_px.y);
  return T_map_cam * camera.unproject(undistorted_px, static_cast<double>(keypoint.depth_m));
}

}  // namespace

MapPoint makeMapPoint(const core::Keypoint& keypoint, const OrbDescriptor& descriptor, const core::CameraModel& camera,
                      const Eigen::Isometry3d& T_map_cam) {
  MapPoint point;
  point.p_map_m = measuredPoint_map(keypoint, camera, T_map_cam);
  point.information_per_m2 = measurementInformation(keypoint, camera, T_map_cam.linear());
  describeFrom(point, keypoint, descriptor, T_map_cam);
  return point;
}

void fuseMeasurement(MapPoint& point, const core::Keypoint& keypoint, const core::CameraModel& camera,
                     const Eigen::Isometry3d& T_map_cam) {
  const Eigen::Matrix3d information = measurementInformation(keypoint, camera, T_map_cam.linear());
  const Eigen::Matrix3d sum = point.information_per_m2 + information;
  const Eigen::Vector3d measured_map_m = measuredPoint_map(keypoint, camera, T_map_cam);
  point.p_map_m += sum.ldlt().solve(information * (measured_map_m - point.p_map_m));
  point.information_per_m2 = sum;
}

void move(MapPoint& point, const Eigen::Isometry3d& correction) {
  point.p_map_m = correction * point.p_map_m;
  point.information_per_m2 = correction.linear() * point.information_per_m2 * correction.linear().transpose();
  point.viewedFrom_map_m = correction * point.viewedFrom_map_m;
}

void describeFrom(MapPoint& point, const core::Keypoint& keypoint, const OrbDescriptor& descriptor,
                  const Eigen::Isometry3d& T_map_cam) {
  point.descriptor = descriptor;
  point.scale = static_cast<double>(keypoint.scale);
  point.viewedFrom_map_m = T_map_cam.translation();
}

std::optional<ProjectedPoint> project(PointId id, const MapPoint& point, const core::CameraModel& camera,
                                      const Eigen::Isometry3d& T_cam_map) {
  const Eigen::Vector3d p_cam_m = T_cam_map * point.p_map_m;
  if (p_cam_m.z() < kMinDepth_m) return std::nullopt;
  const auto raw_px = camera.seenAt(p_cam_m);
  if (!raw_px) return std::nullopt;
  const Eigen::Vector3d fromReference_m = point.p_map_m - point.viewedFrom_map_m;
  const Eigen::Vector3d fromCamera_m = T_cam_map.linear().transpose() * p_cam_m;
  const double referenceDistance_m = fromReference_m.norm();
  const double distance_m = fromCamera_m.norm();
  if (fromReference_m.dot(fromCamera_m) < kMinViewCosine * referenceDistance_m * distance_m) return std::nullopt;
  const double scale = point.scale * referenceDistance_m / distance_m;
  return ProjectedPoint{id, &point.descriptor, camera.project(p_cam_m), scale, *raw_px, p_cam_m.z()};
}

}  // namespace wardslam::odometry
