#pragma once

#include <cstddef>
#include <vector>

#include "wardslam/core/trajectory.h"

namespace wardslam::evaluation {

/// Poses of two trajectories that were taken at the same time, by index.
struct PosePair {
  std::size_t groundTruth = 0;
  std::size_t estimate = 0;
};

/// How far apart in time two poses may be to be compared, as in the TUM RGB-D benchmark.
inline constexpr double kMaxDifference_s = 0.02;

/// One-to-one, in order of ground truth: of all pairs closer than `maxDifference_s` (strictly) the closest is taken
/// first, as associate.py of the TUM RGB-D benchmark does.
[[nodiscard]] std::vector<PosePair> associate(const core::Trajectory& groundTruth, const core::Trajectory& estimate,
                                              double maxDifference_s = kMaxDifference_s);

}  // namespace wardslam::evaluation
