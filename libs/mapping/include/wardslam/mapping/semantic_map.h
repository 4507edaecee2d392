#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "wardslam/core/ground_plane.h"
#include "wardslam/core/label_space.h"
#include "wardslam/mapping/floor_plan.h"
#include "wardslam/mapping/map_object.h"
#include "wardslam/mapping/semantic_cloud_tile.h"
#include "wardslam/mapping/zone.h"

namespace wardslam::mapping {

/// Where a keyframe was taken. Its id is the one odometry and graph use.
struct MappedKeyframe {
  double stamp_s = 0.0;
  Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
  std::string zone;         ///< Innermost zone the camera was over; empty = none.
  std::uint32_t piece = 0;  ///< In whose frame the pose is (odometry::Pieces).
  /// End points of what it saw free in a robot's way, from left to right, in its camera frame, level.
  std::vector<Eigen::Vector3f> freeFan_cam_m;
  std::optional<core::GroundPlane> ground;  ///< The floor it stood on, where its image shows it.
};

/// The semantic map as plain data: what the builder makes, the map file stores, and queries read.
/// The map frame has z up and, where the floor was seen at the start, z = 0 on the floor.
struct SemanticMap {
  core::LabelSpace labels = core::LabelSpace::coco();
  std::uint32_t piece = 0;                            ///< That is the map; what is of another has a frame of its own.
  std::map<std::uint64_t, MappedKeyframe> keyframes;  ///< By keyframe id.
  std::map<std::uint64_t, SemanticCloudTile> cloud;   ///< By the keyframe id a tile hangs on.
  std::map<ObjectId, MapObject> objects;
  ObjectId nextObjectId = 1;  ///< No record had this number yet, nor any above.
  std::vector<Zone> zones;
  FloorPlan floorPlan;
};

}  // namespace wardslam::mapping
