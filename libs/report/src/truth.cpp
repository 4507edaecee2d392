#include "truth.h"

namespace wardslam::report {

Comparison compare(const core::Trajectory& groundTruth, const core::Trajectory& estimate) {
  Comparison comparison;
  comparison.ate = evaluation::absoluteTrajectoryError(groundTruth, estimate);
  const Eigen::Isometry3d T_map_truth = comparison.ate.T_groundtruth_estimate.inverse();
  constexpr double kMargin_s = 0.05;
  for (const core::StampedPose& truth : groundTruth) {
    const bool isWithin =
        truth.stamp_s >= estimate.front().stamp_s - kMargin_s && truth.stamp_s <= estimate.back().stamp_s + kMargin_s;
    if (isWithin) comparison.truthInMap.push_back({truth.stamp_s, T_map_truth * truth.T_map_cam});
  }
  return comparison;
}

}  // namespace wardslam::report
