#pragma once

#include <ceres/problem.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <set>
#include <vector>

#include "wardslam/core/ground_plane.h"
#include "wardslam/graph/keyframe_graph.h"

namespace wardslam::graph {

/// What a solver's poses mean, each an odometry::PoseVector.
enum class PoseKind : std::uint8_t { CamFromMap, MapFromCam };

/// Ties the poses of keyframes that stand on one floor: each must see the floor's plane where it saw its ground, as far
/// as what it measured, and how uneven floors are, allow; with a robust loss.
///
/// The plane is a variable like the poses where all of the floor's keyframes are there; else it is as they have it now.
/// It is that, too, where an earlier run's keyframes are held: that floor is known.
class FloorTies {
 public:
  FloorTies() = default;  ///< No floor.

  /// Of these keyframes of the graph.
  FloorTies(const KeyframeGraph& graph, const std::set<KeyframeId>& keyframes);

  /// `poseOf` tells where the solver has a pose; null for one it does not have. `weight`: of these ties beside what
  /// else the solver has. Call once; planes live as long as this.
  void addTo(ceres::Problem& problem, PoseKind kind, const std::function<double*(KeyframeId)>& poseOf,
             double weight = 1.0);

  /// After addTo(): the planes that are variables, three numbers each.
  [[nodiscard]] std::vector<double*> variablePlanes();

 private:
  struct Tie {
    KeyframeId keyframe = 0;
    core::GroundPlane ground;
    Eigen::Matrix3d whitening;
  };

  struct Plane {
    Eigen::Matrix3d R_map_floor;
    Eigen::Vector3d middle_map_m;
    /// Slopes along x and y of that, and offset at the middle (m).
    Eigen::Vector3d variable = Eigen::Vector3d::Zero();
    bool isVariable = false;
    std::vector<Tie> ties;
  };

  struct Error;

  std::vector<Plane> planes_;
};

}  // namespace wardslam::graph
