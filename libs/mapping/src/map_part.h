#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "object_database.h"
#include "object_table.h"
#include "semantic_cloud.h"
#include "wardslam/core/ground_plane.h"
#include "wardslam/mapping/mapping_options.h"

namespace wardslam::mapping {

/// What pieces have each.
struct Part {
  explicit Part(const MappingOptions& options)
      : cloud(options.cloud), objects(options.objects), table(options.objects) {}
  SemanticCloud cloud;
  ObjectDatabase objects;
  ObjectTable table;
  std::set<ObjectId> touched;    ///< To be described anew.
  std::set<ObjectId> described;  ///< Since boxes were compared last.
};

struct PlacedKeyframe {
  std::uint32_t piece = 0;
  double stamp_s = 0.0;
  Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Vector3f> freeFan_cam_m;
  std::optional<core::GroundPlane> ground;
};

}  // namespace wardslam::mapping
