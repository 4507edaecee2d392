#pragma once

#include <Eigen/Core>
#include <vector>

#include "semantic_cloud.h"

namespace wardslam::mapping {

/// Whether these places (map frame) were seen to be empty: for half of them or more, a keyframe has points behind on
/// the same line of sight, which it could not have seen through a thing. What nobody has seen does not count as empty.
/// Keyframes farther away than `range_m` are not asked.
[[nodiscard]] bool wasSeenThrough(const SemanticCloud& cloud, const std::vector<Eigen::Vector3f>& places_m,
                                  double range_m);

}  // namespace wardslam::mapping
