#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "wardslam/odometry/keyframe.h"
#include "wardslam/odometry/map_point.h"

namespace wardslam::odometry {

/// Two submaps turned out to overlap: the keyframes of the first now belong to the second, in its map frame.
struct SubmapJoin {
  std::uint32_t from = 0;
  std::uint32_t into = 0;
};

/// Better knowledge of what tracking rests on. What is not named stays as it is.
struct MapUpdate {
  std::map<KeyframeId, Eigen::Isometry3d> T_map_cam;
  std::map<PointId, Eigen::Vector3d> p_map_m;
  std::vector<PointId> removedPoints;
  std::map<PointId, PointId> fusedPoints;  ///< The first turned out to be the second.

  /// A place that was left long ago and is in sight again: its points, and which keyframe saw which.
  std::map<PointId, MapPoint> recalledPoints;
  std::map<KeyframeId, std::vector<PointId>> recalledKeyframes;

  std::optional<SubmapJoin> joined;

  [[nodiscard]] bool empty() const {
    return T_map_cam.empty() && p_map_m.empty() && removedPoints.empty() && fusedPoints.empty() &&
           recalledPoints.empty();
  }
};

}  // namespace wardslam::odometry
