#pragma once

#include <cstddef>
#include <vector>

#include "wardslam/core/stamp_association.h"
#include "wardslam/core/trajectory.h"

namespace wardslam::evaluation {

/// Poses of two trajectories that were taken at the same time, by index.
struct PosePair {
  std::size_t groundTruth = 0;
  std::size_t estimate = 0;
};

/// One-to-one, in order of ground truth: of all pairs closer than `maxDifference_s` (strictly) the closest is taken
/// first, as associate.py of the TUM RGB-D benchmark does.
[[nodiscard]] std::vector<PosePair> associate(const core::Trajectory& groundTruth, const core::Trajectory& estimate,
                                              double maxDifference_s = core::kMaxStampDifference_s);

}  // namespace wardslam::evaluation
