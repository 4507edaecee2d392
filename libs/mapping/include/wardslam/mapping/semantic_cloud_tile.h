#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "wardslam/core/label_space.h"

namespace wardslam::mapping {

using ObjectId = std::uint32_t;  ///< Unique within a map, never used again; 0 = none.

/// One point of the semantic cloud (P8), fused from all sightings of its voxel.
struct SemanticPoint {
  Eigen::Vector3f p_cam_m = Eigen::Vector3f::Zero();  ///< In the camera frame of the tile's keyframe.
  std::array<std::uint8_t, 3> color_rgb{};
  core::ClassId classId = 0;
  ObjectId object = 0;
  std::uint16_t sightings = 0;  ///< Frames that saw it where it is.
};

/// The part of the cloud that hangs on one keyframe and moves with it: points first seen from there.
struct SemanticCloudTile {
  std::vector<SemanticPoint> points;
};

}  // namespace wardslam::mapping
