#include "local_map.h"

#include <algorithm>
#include <cmath>

#include "wardslam/odometry/depth_noise.h"

namespace wardslam::odometry {
namespace {

constexpr double kMinViewCosine = 0.5;  // ORB tells little beyond 60 degrees of turning

/// Inverse covariance, in the map frame, of the point that a key point with depth measures.
Eigen::Matrix3d measurementInformation(const core::Keypoint& keypoint, const core::CameraModel& camera,
                                       const Eigen::Matrix3d& R_map_cam) {
  const double z_m = keypoint.depth_m;
  const double sigma_z_m = kinectDepthSigma_m(z_m);
  const double sigma_xy_m = z_m / camera.fx_px * static_cast<double>(keypoint.scale);
  const Eigen::Vector3d ray(keypoint.undistorted_px.x, keypoint.undistorted_px.y, 1.0);
  const Eigen::Vector3d direction = camera.unproject(ray.head<2>(), 1.0);
  Eigen::Matrix3d J = Eigen::Matrix3d::Identity();  // d p_cam / d (x, y at z; z)
  J.col(2) = direction;
  const Eigen::Vector3d variance(sigma_xy_m * sigma_xy_m, sigma_xy_m * sigma_xy_m, sigma_z_m * sigma_z_m);
  const Eigen::Matrix3d covariance_cam = J * variance.asDiagonal() * J.transpose();
  return R_map_cam * covariance_cam.inverse() * R_map_cam.transpose();
}

Eigen::Vector3d measuredPoint_map(const core::Keypoint& keypoint, const core::CameraModel& camera,
                                  const Eigen::Isometry3d& T_map_cam) {
  return T_map_cam * camera.unproject({keypoint.undistorted_px.x, keypoint.undistorted_px.y},
                                      static_cast<double>(keypoint.depth_m));
}

}  // namespace

PointId LocalMap::add(const core::Keypoint& keypoint, const OrbDescriptor& descriptor, const core::CameraModel& camera,
                      const Eigen::Isometry3d& T_map_cam, std::uint64_t frame) {
  MapPoint point;
  point.p_map_m = measuredPoint_map(keypoint, camera, T_map_cam);
  point.information_per_m2 = measurementInformation(keypoint, camera, T_map_cam.linear());
  point.viewedFrom_map_m = T_map_cam.translation();
  point.descriptor = descriptor;
  point.scale = static_cast<double>(keypoint.scale);
  point.lastSeenFrame = frame;
  points_.emplace(nextId_, point);
  return nextId_++;
}

const MapPoint* LocalMap::find(PointId id) const {
  const auto found = points_.find(id);
  return found == points_.end() ? nullptr : &found->second;
}

std::optional<ProjectedPoint> LocalMap::project(PointId id, const core::CameraModel& camera,
                                                const Eigen::Isometry3d& T_cam_map) const {
  const MapPoint& point = points_.at(id);
  const Eigen::Vector3d p_cam_m = T_cam_map * point.p_map_m;
  if (p_cam_m.z() < 0.1) return std::nullopt;
  const Eigen::Vector2d undistorted_px = camera.project(p_cam_m);
  if (undistorted_px.x() < 0 || undistorted_px.x() > camera.width_px - 1 || undistorted_px.y() < 0 ||
      undistorted_px.y() > camera.height_px - 1) {
    return std::nullopt;
  }
  const Eigen::Vector3d fromReference_m = point.p_map_m - point.viewedFrom_map_m;
  const Eigen::Vector3d fromCamera_m = T_cam_map.linear().transpose() * p_cam_m;
  const double referenceDistance_m = fromReference_m.norm();
  const double distance_m = fromCamera_m.norm();
  if (fromReference_m.dot(fromCamera_m) < kMinViewCosine * referenceDistance_m * distance_m) return std::nullopt;
  return ProjectedPoint{id, &point.descriptor, undistorted_px, point.scale * referenceDistance_m / distance_m};
}

void LocalMap::observe(PointId id, const core::Keypoint& keypoint, const core::CameraModel& camera,
                       const Eigen::Isometry3d& T_map_cam, std::uint64_t frame) {
  MapPoint& point = points_.at(id);
  point.lastSeenFrame = frame;
  ++point.timesFound;
  if (!keypoint.hasDepth() || point.timesFound > options_.max_fused) return;
  const Eigen::Matrix3d information = measurementInformation(keypoint, camera, T_map_cam.linear());
  const Eigen::Matrix3d sum = point.information_per_m2 + information;
  const Eigen::Vector3d measured_map_m = measuredPoint_map(keypoint, camera, T_map_cam);
  point.p_map_m += sum.ldlt().solve(information * (measured_map_m - point.p_map_m));
  point.information_per_m2 = sum;
}

void LocalMap::updateAppearance(PointId id, const core::Keypoint& keypoint, const OrbDescriptor& descriptor,
                                const Eigen::Isometry3d& T_map_cam) {
  MapPoint& point = points_.at(id);
  point.descriptor = descriptor;
  point.scale = static_cast<double>(keypoint.scale);
  point.viewedFrom_map_m = T_map_cam.translation();
}

void LocalMap::apply(const MapUpdate& update) {
  for (const auto& [id, p_map_m] : update.p_map_m) {
    if (const auto point = points_.find(id); point != points_.end()) point->second.p_map_m = p_map_m;
  }
  for (const PointId id : update.removedPoints) points_.erase(id);
}

void LocalMap::cull() {
  for (auto it = points_.begin(); it != points_.end();) {
    const bool isUnreliable = it->second.timesFound < options_.min_found_ratio * it->second.timesVisible;
    it = isUnreliable ? points_.erase(it) : std::next(it);
  }
  const auto limit = static_cast<std::size_t>(options_.max_points);
  if (points_.size() <= limit) return;
  std::vector<std::uint64_t> lastSeen;
  for (const auto& [id, point] : points_) lastSeen.push_back(point.lastSeenFrame);
  const auto oldestKept = lastSeen.begin() + static_cast<std::ptrdiff_t>(lastSeen.size() - limit);
  std::nth_element(lastSeen.begin(), oldestKept, lastSeen.end());
  for (auto it = points_.begin(); it != points_.end();) {
    it = it->second.lastSeenFrame < *oldestKept ? points_.erase(it) : std::next(it);
  }
}

}  // namespace wardslam::odometry
