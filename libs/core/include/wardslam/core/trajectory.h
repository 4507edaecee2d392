#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace wardslam::core {

/// A pose with its time. `T_a_b` takes points of frame b into frame a; see docs/frames_and_units.md.
struct StampedPose {
  double stamp_s = 0.0;  ///< UNIX time, UTC.
  Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
  bool isBridged = false;  ///< Nothing was seen at that time: a place on the way between two where something was.
};

/// In order of time.
using Trajectory = std::vector<StampedPose>;

}  // namespace wardslam::core
