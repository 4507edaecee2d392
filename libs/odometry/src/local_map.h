#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "wardslam/core/camera_model.h"
#include "wardslam/core/keypoint.h"
#include "wardslam/odometry/keyframe.h"
#include "wardslam/odometry/matcher.h"
#include "wardslam/odometry/odometry_options.h"

namespace wardslam::odometry {

/// A static place in the world that looks the same from image to image.
struct MapPoint {
  Eigen::Vector3d p_map_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d information_per_m2 = Eigen::Matrix3d::Identity();  ///< Inverse covariance of p_map_m.
  Eigen::Vector3d viewedFrom_map_m = Eigen::Vector3d::Zero();        ///< Centre of the camera that made it.
  OrbDescriptor descriptor{};
  double scale = 1.0;  ///< Keypoint::scale it was seen with from there.
  std::uint64_t lastSeenFrame = 0;
  int timesVisible = 1;  ///< Images in which it should have been found.
  int timesFound = 1;    ///< Images in which it was.
};

/// The points tracking works against: bounded in number, forgetting what was not seen for longest.
class LocalMap {
 public:
  explicit LocalMap(const LocalMapOptions& options) : options_(options) {}

  /// Makes a point of a key point with depth.
  PointId add(const core::Keypoint& keypoint, const OrbDescriptor& descriptor, const core::CameraModel& camera,
              const Eigen::Isometry3d& T_map_cam, std::uint64_t frame);

  [[nodiscard]] const MapPoint* find(PointId id) const;
  [[nodiscard]] const std::map<PointId, MapPoint>& points() const { return points_; }

  /// Where the camera should see a point; nothing when outside the image, behind the camera, or seen from too
  /// different an angle.
  [[nodiscard]] std::optional<ProjectedPoint> project(PointId id, const core::CameraModel& camera,
                                                      const Eigen::Isometry3d& T_cam_map) const;

  void countVisible(PointId id) { ++points_.at(id).timesVisible; }

  /// The point was found again: refines its position by what this image measured.
  void observe(PointId id, const core::Keypoint& keypoint, const core::CameraModel& camera,
               const Eigen::Isometry3d& T_map_cam, std::uint64_t frame);
  void updateAppearance(PointId id, const core::Keypoint& keypoint, const OrbDescriptor& descriptor,
                        const Eigen::Isometry3d& T_map_cam);

  /// Better positions, and points to forget.
  void apply(const MapUpdate& update);

  /// Drops points that are rarely found where they should be and, above the limit, those unseen for longest.
  void cull();

 private:
  LocalMapOptions options_;
  PointId nextId_ = 1;
  std::map<PointId, MapPoint> points_;
};

}  // namespace wardslam::odometry
