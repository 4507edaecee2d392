#include "wardslam/evaluation/relative_pose_error.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

namespace wardslam::evaluation {
namespace {

using IndexPair = std::pair<std::size_t, std::size_t>;

double secondsApart(const core::StampedPose& pose, double stamp_s) { return std::abs(pose.stamp_s - stamp_s); }

/// Index of the pose nearest in time; the trajectory must not be empty. Bisects as the benchmark's script does, not
/// with std::lower_bound: which of two equally near poses is taken depends on the order of the visits.
std::size_t findNearest(const core::Trajectory& trajectory, double stamp_s) {
  std::size_t best = 0;
  std::size_t begin = 0;
  std::size_t end = trajectory.size();
  while (begin < end) {
    const std::size_t middle = (begin + end) / 2;
    if (secondsApart(trajectory[middle], stamp_s) < secondsApart(trajectory[best], stamp_s)) best = middle;
    if (trajectory[middle].stamp_s == stamp_s) return middle;
    if (trajectory[middle].stamp_s > stamp_s) {
      end = middle;
    } else {
      begin = middle + 1;
    }
  }
  return best;
}

/// Every pose with the one nearest to `delta_s` later; where that is the last one, the run may have ended too early
/// for the full time, and the pair is left out.
std::vector<IndexPair> pairsApart(const core::Trajectory& trajectory, double delta_s) {
  std::vector<IndexPair> pairs;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const std::size_t j = findNearest(trajectory, trajectory[i].stamp_s + delta_s);
    if (j + 1 != trajectory.size()) pairs.emplace_back(i, j);
  }
  return pairs;
}

std::vector<IndexPair> sampleOf(std::vector<IndexPair> pairs) {
  if (pairs.size() <= kMaxRelativePosePairs) return pairs;
  std::vector<IndexPair> sample;
  sample.reserve(kMaxRelativePosePairs);
  std::mt19937 random;  // NOLINT(cert-msc51-cpp): the same sample every time, so that figures repeat
  std::sample(pairs.begin(), pairs.end(), std::back_inserter(sample), kMaxRelativePosePairs, random);
  return sample;
}

/// Seconds between successive poses.
double medianInterval(const core::Trajectory& trajectory) {
  std::vector<double> intervals_s;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    intervals_s.push_back(trajectory[i].stamp_s - trajectory[i - 1].stamp_s);
  }
  return summarise(std::move(intervals_s)).median;
}

/// As the benchmark: acos of the trace, whose coarse steps near zero belong to the published figures.
double angleInDegrees(const Eigen::Isometry3d& T) {
  const double cosine = (T.linear().trace() - 1.0) / 2.0;
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / M_PI;
}

Eigen::Isometry3d motion(const core::StampedPose& from, const core::StampedPose& to) {
  return to.T_map_cam.inverse() * from.T_map_cam;
}

}  // namespace

RelativePoseError relativePoseError(const core::Trajectory& groundTruth, const core::Trajectory& estimate,
                                    double delta_s) {
  if (groundTruth.size() < 2) return {};
  const double maxDifference_s = 2.0 * medianInterval(groundTruth);

  std::vector<double> translations_m;
  std::vector<double> rotations_deg;
  for (const auto& [i, j] : sampleOf(pairsApart(estimate, delta_s))) {
    const core::StampedPose& true0 = groundTruth[findNearest(groundTruth, estimate[i].stamp_s)];
    const core::StampedPose& true1 = groundTruth[findNearest(groundTruth, estimate[j].stamp_s)];
    if (secondsApart(true0, estimate[i].stamp_s) > maxDifference_s) continue;
    if (secondsApart(true1, estimate[j].stamp_s) > maxDifference_s) continue;

    const Eigen::Isometry3d error = motion(estimate[i], estimate[j]).inverse() * motion(true0, true1);
    translations_m.push_back(error.translation().norm());
    rotations_deg.push_back(angleInDegrees(error));
  }
  return {summarise(std::move(translations_m)), summarise(std::move(rotations_deg))};
}

}  // namespace wardslam::evaluation
