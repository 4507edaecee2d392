#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "wardslam/graph/keyframe_graph.h"
#include "wardslam/graph/loop_verification.h"
#include "wardslam/odometry/map_update.h"

namespace wardslam::graph {

/// What changes of keyframes and points once they are in a graph.
struct GraphState {
  struct Keyframe {
    KeyframeId id = 0;
    Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
    std::vector<odometry::Sighting> sightings;
    std::uint32_t submap = 0;
    bool isSettled = false;
    KeyframeId floor = 0;
  };
  struct Point {
    PointId id = 0;
    Eigen::Vector3d p_map_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d viewedFrom_map_m = Eigen::Vector3d::Zero();
    Eigen::Matrix3d information_per_m2 = Eigen::Matrix3d::Identity();
  };
  std::vector<Keyframe> keyframes;
  std::vector<Point> points;
  std::vector<std::pair<PointId, PointId>> fusedInto;
};

/// By which key points a keyframe can be recognised.
struct RememberedPlace {
  KeyframeId id = 0;
  std::vector<std::uint32_t> keypoints;  ///< Indices into Keyframe::features.
};

/// What a Mapper has found out of runs that met, to be gone on from by another one (Mapper::resume()): the very same
/// comes of it. What the runs themselves hold is not in it.
struct MapperState {
  GraphState graph;
  std::vector<odometry::SubmapJoin> joins;  ///< In their order.
  std::vector<Loop> loops;
  std::vector<std::vector<Loop>> hypotheses;  ///< Not yet confirmed (LoopConfirmation),
  std::vector<std::vector<Loop>> unsettled;   ///< and not seen again.
  std::map<KeyframeId, double> apart_m;       ///< Places with doubles (Lookalikes).
  std::map<KeyframeId, std::vector<Loop>> doubles;
  std::vector<std::vector<RememberedPlace>> places;  ///< Of each run whose places can be recognised.
  std::uint64_t random = 0;  ///< Where OpenCV's random numbers are, which the index of places is made with.
};

}  // namespace wardslam::graph
