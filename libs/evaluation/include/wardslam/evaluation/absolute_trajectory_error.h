#pragma once

#include <Eigen/Geometry>

#include "wardslam/core/trajectory.h"
#include "wardslam/evaluation/error_statistics.h"

namespace wardslam::evaluation {

struct AbsoluteTrajectoryError {
  ErrorStatistics translation_m;  ///< Distance of each aligned position from the true one.
  /// The alignment: p_groundtruth = T_groundtruth_estimate * p_estimate.
  Eigen::Isometry3d T_groundtruth_estimate = Eigen::Isometry3d::Identity();
};

/// ATE of the TUM RGB-D benchmark (Sturm et al., IROS 2012): associated positions, the estimate moved onto the ground
/// truth by the rigid transform of least squares (Horn), no scale.
/// Throws InputError when fewer than two poses can be associated.
[[nodiscard]] AbsoluteTrajectoryError absoluteTrajectoryError(const core::Trajectory& groundTruth,
                                                              const core::Trajectory& estimate);

}  // namespace wardslam::evaluation
