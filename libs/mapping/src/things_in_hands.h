#pragma once

#include <Eigen/Core>
#include <vector>

#include "wardslam/knowledge/motion_rules.h"
#include "wardslam/mapping/view.h"

namespace wardslam::mapping {

/// A thing that somebody may be moving.
struct Handled {
  core::ClassId classId = 0;
  Eigen::Vector3d p_cam_m = Eigen::Vector3d::Zero();  ///< Its middle.
};

/// Instances of which most pixels may move (View::mayMove) though their class does not by itself.
[[nodiscard]] std::vector<Handled> thingsInHands(const View& view, const knowledge::ClassSet& moving);

}  // namespace wardslam::mapping
