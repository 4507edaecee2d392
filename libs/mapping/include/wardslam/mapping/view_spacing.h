#pragma once

#include "wardslam/core/trajectory.h"
#include "wardslam/mapping/mapping_options.h"

namespace wardslam::mapping {

/// Whether the camera has moved, turned or waited enough since the last view of the map for another one.
[[nodiscard]] bool isFarEnough(const ViewOptions& options, const core::StampedPose& last, const core::StampedPose& now);

}  // namespace wardslam::mapping
