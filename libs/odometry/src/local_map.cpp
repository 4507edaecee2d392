#include "local_map.h"

#include <algorithm>
#include <set>

namespace wardslam::odometry {

PointId LocalMap::add(const MapPoint& point) {
  points_.emplace(nextId_, point);
  return nextId_++;
}

void LocalMap::addKeyframe(KeyframeId id, const std::vector<PointId>& points) {
  auto& seen = keyframes_[id];
  for (const PointId point : points) {
    if (points_.count(point) == 0) continue;
    seen.push_back(point);
    seenBy_[point].push_back(id);
  }
}

const MapPoint* LocalMap::find(PointId id) const {
  const auto found = points_.find(id);
  return found == points_.end() ? nullptr : &found->second;
}

std::vector<PointId> LocalMap::neighbourhood(const std::vector<PointId>& seeds) const {
  std::map<KeyframeId, std::size_t> votes;
  for (const PointId seed : seeds) {
    const auto seenBy = seenBy_.find(seed);
    if (seenBy == seenBy_.end()) continue;
    for (const KeyframeId keyframe : seenBy->second) ++votes[keyframe];
  }
  std::vector<std::pair<std::size_t, KeyframeId>> ranking;
  for (const auto& [keyframe, count] : votes) ranking.emplace_back(count, keyframe);
  std::sort(ranking.rbegin(), ranking.rend());
  ranking.resize(std::min(ranking.size(), static_cast<std::size_t>(options_.max_neighbours)));

  std::set<PointId> points;
  for (const auto& [count, keyframe] : ranking) {
    for (const PointId point : keyframes_.at(keyframe)) {
      if (points_.count(point) != 0) points.insert(point);
    }
  }
  return {points.begin(), points.end()};
}

void LocalMap::observe(PointId id, const core::Keypoint& keypoint, const core::CameraModel& camera,
                       const Eigen::Isometry3d& T_map_cam, std::uint64_t frame) {
  MapPoint& point = points_.at(id);
  point.lastSeenFrame = frame;
  ++point.timesFound;
  if (keypoint.hasDepth() && point.timesFound <= options_.max_fused)
    fuseMeasurement(point, keypoint, camera, T_map_cam);
}

void LocalMap::describe(PointId id, const core::Keypoint& keypoint, const OrbDescriptor& descriptor,
                        const Eigen::Isometry3d& T_map_cam) {
  describeFrom(points_.at(id), keypoint, descriptor, T_map_cam);
}

void LocalMap::apply(const MapUpdate& update) {
  for (const auto& [id, point] : update.recalledPoints) points_.emplace(id, point);
  for (const auto& [id, points] : update.recalledKeyframes) {
    if (keyframes_.count(id) == 0) addKeyframe(id, points);
  }
  for (const auto& [from, into] : update.fusedPoints) fuse(from, into);
  for (const auto& [id, p_map_m] : update.p_map_m) {
    const auto point = points_.find(id);
    if (point == points_.end()) continue;
    point->second.viewedFrom_map_m += p_map_m - point->second.p_map_m;
    point->second.p_map_m = p_map_m;
  }
  for (const PointId id : update.removedPoints) remove(id);
}

void LocalMap::cull() {
  std::vector<PointId> unreliable;
  for (const auto& [id, point] : points_) {
    if (point.timesFound < options_.min_found_ratio * point.timesVisible) unreliable.push_back(id);
  }
  for (const PointId id : unreliable) remove(id);
  forgetOldest();
}

void LocalMap::clear() {
  points_.clear();
  seenBy_.clear();
  keyframes_.clear();
}

void LocalMap::remove(PointId id) {
  points_.erase(id);
  seenBy_.erase(id);
}

void LocalMap::fuse(PointId from, PointId into) {
  const auto seenBy = seenBy_.find(from);
  if (seenBy != seenBy_.end() && points_.count(into) != 0) {
    for (const KeyframeId keyframe : seenBy->second) {
      keyframes_.at(keyframe).push_back(into);
      seenBy_[into].push_back(keyframe);
    }
  }
  remove(from);
}

void LocalMap::forgetOldest() {
  const auto limit = static_cast<std::size_t>(options_.max_points);
  if (points_.size() <= limit) return;
  std::vector<std::pair<std::uint64_t, PointId>> byAge;
  for (const auto& [id, point] : points_) byAge.emplace_back(point.lastSeenFrame, id);
  std::sort(byAge.begin(), byAge.end());
  byAge.resize(byAge.size() - limit);
  for (const auto& [frame, id] : byAge) remove(id);
  for (auto it = keyframes_.begin(); it != keyframes_.end();) {
    auto& points = it->second;
    points.erase(std::remove_if(points.begin(), points.end(), [&](PointId id) { return points_.count(id) == 0; }),
                 points.end());
    it = points.empty() ? keyframes_.erase(it) : std::next(it);
  }
}

}  // namespace wardslam::odometry
