#pragma once

#include "wardslam/core/trajectory.h"
#include "wardslam/evaluation/error_statistics.h"

namespace wardslam::evaluation {

/// Drift over a fixed time: how far the estimated motion is from the true one.
struct RelativePoseError {
  ErrorStatistics translation_m;
  ErrorStatistics rotation_deg;
};

/// RPE of the TUM RGB-D benchmark (Sturm et al., IROS 2012, Eq. 1), `--fixed_delta --delta <delta_s>`: the figures are
/// per `delta_s`. An estimate shorter than `delta_s`, or one the ground truth has no poses for, gives no samples.
/// Of more than kMaxRelativePosePairs pairs a random but repeatable sample is compared.
[[nodiscard]] RelativePoseError relativePoseError(const core::Trajectory& groundTruth, const core::Trajectory& estimate,
                                                  double delta_s = 1.0);

inline constexpr std::size_t kMaxRelativePosePairs = 10000;

}  // namespace wardslam::evaluation
