#pragma once

#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "wardslam/odometry/keyframe.h"
#include "wardslam/odometry/map_update.h"

namespace wardslam::graph {

using odometry::KeyframeId;
using odometry::PointId;

/// A keyframe as it stands in the graph: its pose changes, what it saw does not.
struct KeyframeNode {
  std::shared_ptr<const odometry::Keyframe> keyframe;
  Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
  std::map<PointId, std::size_t> keypointOf;  ///< Points it sees, and the key point of each.
};

/// A map point: where it is and which keyframes see it.
struct PointNode {
  Eigen::Vector3d p_map_m = Eigen::Vector3d::Zero();
  std::set<KeyframeId> seenBy;
};

/// Keyframes and points, tied by sightings. Two keyframes that see the same points are covisible.
class KeyframeGraph {
 public:
  void insert(const std::shared_ptr<const odometry::Keyframe>& keyframe);

  [[nodiscard]] const std::map<KeyframeId, KeyframeNode>& keyframes() const { return keyframes_; }
  [[nodiscard]] const std::map<PointId, PointNode>& points() const { return points_; }

  /// Keyframes that share points with this one and how many, most first.
  [[nodiscard]] std::vector<std::pair<KeyframeId, std::size_t>> covisible(KeyframeId id) const;

  void setPose(KeyframeId id, const Eigen::Isometry3d& T_map_cam) { keyframes_.at(id).T_map_cam = T_map_cam; }
  void setPosition(PointId id, const Eigen::Vector3d& p_map_m) { points_.at(id).p_map_m = p_map_m; }
  void removeSighting(KeyframeId keyframe, PointId point);
  void removePoint(PointId point);

 private:
  std::map<KeyframeId, KeyframeNode> keyframes_;
  std::map<PointId, PointNode> points_;
};

}  // namespace wardslam::graph
