#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>

#include "wardslam/core/camera_model.h"
#include "wardslam/core/keypoint.h"
#include "wardslam/odometry/matcher.h"
#include "wardslam/odometry/orb_descriptor.h"

namespace wardslam::odometry {

/// A static place in the world that looks the same from image to image.
struct MapPoint {
  Eigen::Vector3d p_map_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d information_per_m2 = Eigen::Matrix3d::Identity();  ///< Inverse covariance of p_map_m.
  Eigen::Vector3d viewedFrom_map_m = Eigen::Vector3d::Zero();        ///< Centre of the camera that described it.
  OrbDescriptor descriptor{};
  core::SemanticDescriptor semanticDescriptor;  ///< Empty: none.
  double scale = 1.0;                           ///< Keypoint::scale it was seen with from there.
  std::uint64_t lastSeenFrame = 0;
  int timesVisible = 1;  ///< Images in which it should have been found.
  int timesFound = 1;    ///< Images in which it was.
};

/// The point that a key point with depth measures.
[[nodiscard]] MapPoint makeMapPoint(const core::Keypoint& keypoint, const OrbDescriptor& descriptor,
                                    const core::CameraModel& camera, const Eigen::Isometry3d& T_map_cam);

/// Refines the position by one more measurement with depth, weighted by information.
void fuseMeasurement(MapPoint& point, const core::Keypoint& keypoint, const core::CameraModel& camera,
                     const Eigen::Isometry3d& T_map_cam);

/// Moves it within the map frame, with all that is known of it.
void move(MapPoint& point, const Eigen::Isometry3d& correction);

/// Remembers how the point looks from here.
void describeFrom(MapPoint& point, const core::Keypoint& keypoint, const OrbDescriptor& descriptor,
                  const Eigen::Isometry3d& T_map_cam);

/// Where the camera should see a point; nothing when outside the image, behind the camera, or seen from too
/// different an angle. The result refers to the point's descriptor.
[[nodiscard]] std::optional<ProjectedPoint> project(PointId id, const MapPoint& point, const core::CameraModel& camera,
                                                    const Eigen::Isometry3d& T_cam_map);

}  // namespace wardslam::odometry
