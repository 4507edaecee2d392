#pragma once

#include <vector>

#include "wardslam/core/trajectory.h"
#include "wardslam/evaluation/absolute_trajectory_error.h"

namespace wardslam::report {

/// A run and the truth laid over each other.
struct Comparison {
  evaluation::AbsoluteTrajectoryError ate;
  core::Trajectory truthInMap;  ///< While the run lasted.
};

/// Throws core::InputError where fewer than two poses belong together.
[[nodiscard]] Comparison compare(const core::Trajectory& groundTruth, const core::Trajectory& estimate);

}  // namespace wardslam::report
