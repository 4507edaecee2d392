#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "wardslam/core/trajectory.h"
#include "wardslam/evaluation/error_statistics.h"

namespace wardslam::evaluation {

/// How far a position was from the true one.
struct ErrorAt {
  double stamp_s = 0.0;  ///< Of the estimate.
  double distance_m = 0.0;
};

/// How an estimate may be moved onto the truth before it is compared: turned and shifted, SE(3), or also scaled,
/// Sim(3), which flatters whoever drifts in scale and is how systems without depth are judged.
enum class Alignment { Rigid, Similarity };

struct AbsoluteTrajectoryError {
  ErrorStatistics translation_m;  ///< Distance of each aligned position from the true one.
  std::vector<ErrorAt> errors;    ///< Each of these, in order of time.
  /// The alignment: p_groundtruth = T_groundtruth_estimate * (scale * p_estimate).
  Eigen::Isometry3d T_groundtruth_estimate = Eigen::Isometry3d::Identity();
  double scale = 1.0;  ///< Not 1 with Alignment::Similarity alone.
};

/// ATE of the TUM RGB-D benchmark (Sturm et al., IROS 2012): associated positions, the estimate moved onto the ground
/// truth by the transform of least squares (Horn; Umeyama where a scale is asked for).
/// Throws InputError when fewer than two poses can be associated.
[[nodiscard]] AbsoluteTrajectoryError absoluteTrajectoryError(const core::Trajectory& groundTruth,
                                                              const core::Trajectory& estimate,
                                                              Alignment alignment = Alignment::Rigid);

}  // namespace wardslam::evaluation
