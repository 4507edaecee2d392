#pragma once

#include "wardslam/core/trajectory.h"

namespace wardslam::evaluation {

/// Poses farther apart than this leave a hole: the camera's place was unknown in between.
inline constexpr double kMaxGap_s = 0.2;

/// Share (0..1) of the time from `begin_s` to `end_s` for which the trajectory knows the pose: the intervals between
/// successive poses, except holes longer than kMaxGap_s. To be told beside every error, for a run that loses half of
/// a recording can look good.
[[nodiscard]] double coverage(const core::Trajectory& trajectory, double begin_s, double end_s);

}  // namespace wardslam::evaluation
