#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "wardslam/core/rigid_transform.h"
#include "wardslam/odometry/keyframe.h"
#include "wardslam/odometry/map_point.h"

namespace wardslam::odometry {

/// Two submaps turned out to overlap: the keyframes of the first now belong to the second, in its map frame.
struct SubmapJoin {
  std::uint32_t from = 0;
  std::uint32_t into = 0;
};

/// A keyframe that was given up because others show the same: what hung on it hangs on one that stays.
struct RemovedKeyframe {
  KeyframeId id = 0;
  KeyframeId heir = 0;
  Eigen::Isometry3d T_heir_cam = Eigen::Isometry3d::Identity();  ///< Of the removed, seen from the heir.
};

/// A loop: where a place was seen again, and from where.
struct PlaceSeenAgain {
  KeyframeId older = 0;
  KeyframeId newer = 0;
  Eigen::Isometry3d T_older_newer = Eigen::Isometry3d::Identity();
};

/// Better knowledge of what tracking rests on, as of one keyframe. Of what was known then, what is not named stays as
/// it is. Keyframes that are younger are placed by their poses from one to the next and move as that keyframe does
/// (correctionOf).
struct MapUpdate {
  KeyframeId newestKeyframe = 0;  ///< The newest that was known; named in T_map_cam. 0: nothing younger moves.
  std::uint32_t submap = 0;       ///< Of that keyframe, by the number it had when it was made.
  bool movesTheMap = false;       ///< A loop was closed or submaps were joined, and not only a few keyframes adjusted.
  std::map<KeyframeId, Eigen::Isometry3d> T_map_cam;
  std::map<PointId, Eigen::Vector3d> p_map_m;
  std::vector<RemovedKeyframe> removedKeyframes;  ///< In order: an heir may be removed itself later on.
  std::vector<PointId> removedPoints;
  std::map<PointId, PointId> fusedPoints;  ///< The first turned out to be the second.

  /// A known place that comes into sight: its points, and which keyframe saw which.
  std::map<PointId, MapPoint> recalledPoints;
  std::map<KeyframeId, std::vector<PointId>> recalledKeyframes;

  std::optional<SubmapJoin> joined;
  std::optional<PlaceSeenAgain> seenAgain;  ///< What moves the map.

  [[nodiscard]] bool empty() const {
    return T_map_cam.empty() && p_map_m.empty() && removedKeyframes.empty() && removedPoints.empty() &&
           fusedPoints.empty() && recalledPoints.empty();
  }
};

/// The transform within the map frame that all that is younger than the update follows: keyframes, points, the camera,
/// views underway. `T_map_newest`: where its newest keyframe was believed to be until now.
[[nodiscard]] inline Eigen::Isometry3d correctionOf(const MapUpdate& update, const Eigen::Isometry3d& T_map_newest) {
  const auto moved = update.T_map_cam.find(update.newestKeyframe);
  if (moved == update.T_map_cam.end()) return Eigen::Isometry3d::Identity();
  return core::rigid(moved->second * T_map_newest.inverse());
}

}  // namespace wardslam::odometry
