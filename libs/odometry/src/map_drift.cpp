#include "map_drift.h"

#include <iterator>

namespace wardslam::odometry {
namespace {

constexpr std::size_t kMostKeyframes = 4096;  // remembered: of places seen longer ago nothing is said

/// What a keyframe adds, in its pose's own covariance: the points it makes err as it does, and key points that are
/// wrong together (lens, clock, noise of one image) are not as many opinions. Measured: with this the normalised errors
/// of ways of 1 to 10 s are about 6 on average, their number of dimensions (docs/benchmark.md).
constexpr double kPerKeyframe = 2.0;

}  // namespace

void MapDrift::begin(KeyframeId first) { keep(first, {}); }

void MapDrift::add(KeyframeId id, const Eigen::Isometry3d& T_before_this, const PoseCovariance& ofPose) {
  Entry entry{T_before_this, kPerKeyframe * ofPose, {}};
  entry.drift = entry.added;
  if (!keyframes_.empty()) entry.drift += transformed(keyframes_.rbegin()->second.drift, T_before_this);
  keep(id, entry);
}

void MapDrift::seeAgain(const PlaceSeenAgain& place, bool isMoved) {
  const auto newer = keyframes_.find(place.newer);
  const auto older = keyframes_.find(place.older);
  const bool isOfEarlierRun = place.older <= lastOfEarlierRuns_;
  if (newer == keyframes_.end() || (older == keyframes_.end() && !isOfEarlierRun)) return;
  const PoseCovariance there = isOfEarlierRun ? PoseCovariance(PoseCovariance::Zero()) : older->second.drift;
  const PoseCovariance here = transformed(there, place.T_older_newer) + newer->second.added;
  if (!isMoved && here.trace() >= newer->second.drift.trace()) return;
  newer->second.drift = here;
  for (auto next = std::next(newer); next != keyframes_.end(); ++next) {
    Entry& entry = next->second;
    entry.drift = transformed(std::prev(next)->second.drift, entry.T_before_this) + entry.added;
  }
}

PoseCovariance MapDrift::at(const Eigen::Isometry3d& T_keyframe_cam) const {
  if (keyframes_.empty()) return PoseCovariance::Zero();
  return transformed(keyframes_.rbegin()->second.drift, T_keyframe_cam);
}

void MapDrift::keep(KeyframeId id, const Entry& entry) {
  keyframes_[id] = entry;
  if (keyframes_.size() > kMostKeyframes) keyframes_.erase(keyframes_.begin());
}

}  // namespace wardslam::odometry
