#include "truth.h"

namespace wardslam::report {

Comparison compare(const core::Trajectory& groundTruth, const core::Trajectory& estimate) {
  Comparison comparison;
  comparison.ate = evaluation::absoluteTrajectoryError(groundTruth, estimate);
  const Eigen::Isometry3d T_map_truth = comparison.ate.T_groundtruth_estimate.inverse();
  constexpr double kMargin_s = 0.05;
  for (const auto& [stamp_s, T_truth_cam] : groundTruth) {
    const bool isWithin =
        stamp_s >= estimate.front().stamp_s - kMargin_s && stamp_s <= estimate.back().stamp_s + kMargin_s;
    if (isWithin) comparison.truthInMap.push_back({stamp_s, T_map_truth * T_truth_cam});
  }
  return comparison;
}

}  // namespace wardslam::report
