#include "association.h"

namespace wardslam::evaluation {
namespace {

std::vector<double> stampsOf(const core::Trajectory& trajectory) {
  std::vector<double> stamps_s;
  stamps_s.reserve(trajectory.size());
  for (const core::StampedPose& pose : trajectory) stamps_s.push_back(pose.stamp_s);
  return stamps_s;
}

}  // namespace

std::vector<PosePair> associate(const core::Trajectory& groundTruth, const core::Trajectory& estimate,
                                double maxDifference_s) {
  std::vector<PosePair> pairs;
  for (const auto& [i, j] : core::associateByStamp(stampsOf(groundTruth), stampsOf(estimate), maxDifference_s)) {
    pairs.push_back({i, j});
  }
  return pairs;
}

}  // namespace wardslam::evaluation
