#include "wardslam/evaluation/absolute_trajectory_error.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "association.h"
#include "wardslam/core/errors.h"

namespace wardslam::evaluation {
namespace {

std::string timeSpan(const core::Trajectory& trajectory) {
  if (trajectory.empty()) return "empty";
  char text[64];
  std::snprintf(text, sizeof text, "%.2f .. %.2f s", trajectory.front().stamp_s, trajectory.back().stamp_s);
  return text;
}

void requireTwo(const std::vector<PosePair>& pairs, const core::Trajectory& groundTruth,
                const core::Trajectory& estimate) {
  if (pairs.size() >= 2) return;
  throw core::InputError("at least two poses within 0.02 s of each other are needed but there are " +
                         std::to_string(pairs.size()) + " (ground truth " + timeSpan(groundTruth) + ", trajectory " +
                         timeSpan(estimate) + "); are both of the same recording?");
}

/// An estimate that stands still has no scale that would make it fit better.
double scaleOf(const Eigen::Matrix4d& similarity) {
  const double scale = std::cbrt(similarity.topLeftCorner<3, 3>().determinant());
  return std::isfinite(scale) && scale > 0.0 ? scale : 1.0;
}

/// estimated -> true positions, one a column.
void align(const Eigen::Matrix3Xd& estimated, const Eigen::Matrix3Xd& truth, Alignment alignment,
           AbsoluteTrajectoryError& error) {
  if (alignment == Alignment::Similarity) {
    error.scale = scaleOf(Eigen::umeyama(estimated, truth, /*with_scaling=*/true));
  }
  error.T_groundtruth_estimate.matrix() =
      Eigen::umeyama(Eigen::Matrix3Xd(error.scale * estimated), truth, /*with_scaling=*/false);
}

}  // namespace

AbsoluteTrajectoryError absoluteTrajectoryError(const core::Trajectory& groundTruth, const core::Trajectory& estimate,
                                                Alignment alignment) {
  const std::vector<PosePair> pairs = associate(groundTruth, estimate);
  requireTwo(pairs, groundTruth, estimate);

  Eigen::Matrix3Xd truePositions(3, pairs.size());
  Eigen::Matrix3Xd estimatedPositions(3, pairs.size());
  for (Eigen::Index i = 0; i < truePositions.cols(); ++i) {
    const PosePair& pair = pairs[static_cast<std::size_t>(i)];
    truePositions.col(i) = groundTruth[pair.groundTruth].T_map_cam.translation();
    estimatedPositions.col(i) = estimate[pair.estimate].T_map_cam.translation();
  }

  AbsoluteTrajectoryError error;
  align(estimatedPositions, truePositions, alignment, error);
  const Eigen::VectorXd distances_m =
      (error.T_groundtruth_estimate * (error.scale * estimatedPositions) - truePositions).colwise().norm();
  error.translation_m = summarise({distances_m.begin(), distances_m.end()});
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    error.errors.push_back({estimate[pairs[i].estimate].stamp_s, distances_m(static_cast<Eigen::Index>(i))});
  }
  return error;
}

}  // namespace wardslam::evaluation
