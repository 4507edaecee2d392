#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <set>

#include "wardslam/core/ground_plane.h"
#include "wardslam/graph/keyframe_graph.h"

namespace wardslam::graph {

/// A level patch of ground that keyframes stand on, in the map frame: normal_map · (p - middle_map_m) + offset_m = 0
/// for its points p (m).
struct Floor {
  Eigen::Vector3d normal_map = Eigen::Vector3d::UnitZ();   ///< Unit length, up.
  Eigen::Vector3d middle_map_m = Eigen::Vector3d::Zero();  ///< Of the cameras over it.
  double offset_m = 0.0;

  /// As a camera at `T_map_cam` should see it. Its covariance is by how uneven floors are.
  [[nodiscard]] core::GroundPlane under(const Eigen::Isometry3d& T_map_cam) const;
};

/// What one spot of a floor, `way_m` from its middle, has by itself: of the normal's shifts along two tangents (rad)
/// and of the height (m).
[[nodiscard]] Eigen::Matrix3d unevenness(double way_m);

/// Fewer keyframes on a floor tell nothing of one another.
constexpr std::size_t kFewestOnFloor = 3;

/// Keyframes by the floor they stand on (KeyframeNode::floor), of floors that at least kFewestOnFloor stand on.
[[nodiscard]] std::map<KeyframeId, std::set<KeyframeId>> floorsOf(const KeyframeGraph& graph);

/// Least squares over what these keyframes see beneath them from where they are; stray ones count less. All of them
/// see their ground, and there is one at least.
[[nodiscard]] Floor fitFloor(const KeyframeGraph& graph, const std::set<KeyframeId>& keyframes);

/// Notes which floor a keyframe stands on: that of the keyframe before it, or of one that shares `minSharedPoints` with
/// it, if both see one and the same plane (some 1 degree, 3 cm) and it is that floor's plane still. Else a floor of its
/// own begins: on a ramp, over a step, in another storey. Two floors that a keyframe finds to be one are one from
/// there.
void findFloor(KeyframeGraph& graph, KeyframeId keyframe, std::size_t minSharedPoints);

/// Two keyframes of runs that knew nothing of each other are known to be in one place: where both see a floor and that
/// is one plane (some 3 degrees, 15 cm: a look from afar is no more exact), their floors are one. Whether it was so.
bool uniteFloors(KeyframeGraph& graph, KeyframeId older, KeyframeId newer);

}  // namespace wardslam::graph
