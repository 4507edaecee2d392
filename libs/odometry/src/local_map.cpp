#include "local_map.h"

#include <algorithm>

namespace wardslam::odometry {
namespace {

constexpr std::size_t kMostAtOnce = 2000;  // points to be moved in one image

/// What two maps have under one key. Costs what the smaller one holds.
template <class A, class B, class Visit>
void forEachOfBoth(A& a, B& b, const Visit& visit) {
  if (a.size() <= b.size()) {
    for (auto& [key, value] : a) {
      if (const auto other = b.find(key); other != b.end()) visit(key, value, other->second);
    }
  } else {
    for (auto& [key, value] : b) {
      if (const auto other = a.find(key); other != a.end()) visit(key, other->second, value);
    }
  }
}

}  // namespace

PointId LocalMap::add(const MapPoint& point) {
  points_.emplace(nextId_, point);
  return nextId_++;
}

void LocalMap::addKeyframe(KeyframeId id, const std::vector<PointId>& points) {
  auto& seen = keyframes_[id];
  for (const PointId point : points) link(id, seen, point);
  if (seen.empty()) keyframes_.erase(id);
}

void LocalMap::link(KeyframeId keyframe, std::vector<PointId>& seen, PointId point) {
  if (points_.count(point) == 0) return;
  auto& seenBy = seenBy_[point];
  if (std::find(seenBy.begin(), seenBy.end(), keyframe) != seenBy.end()) return;
  seenBy.push_back(keyframe);
  seen.push_back(point);
}

const MapPoint* LocalMap::find(PointId id) const {
  const auto found = points_.find(id);
  if (found == points_.end()) return nullptr;
  putOff_.settle(id, found->second);
  return &found->second;
}

MapPoint& LocalMap::at(PointId id) {
  MapPoint& point = points_.at(id);
  putOff_.settle(id, point);
  return point;
}

void LocalMap::moveSome() { putOff_.settleSome(points_, kMostAtOnce); }

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

  std::vector<PointId> points;
  for (const auto& [count, keyframe] : ranking) {
    const auto& seen = keyframes_.at(keyframe);
    points.insert(points.end(), seen.begin(), seen.end());
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

void LocalMap::observe(PointId id, const core::Keypoint& keypoint, const core::CameraModel& camera,
                       const Eigen::Isometry3d& T_map_cam, std::uint64_t frame) {
  MapPoint& point = at(id);
  point.lastSeenFrame = frame;
  ++point.timesFound;
  if (keypoint.hasDepth() && point.timesFound <= options_.max_fused)
    fuseMeasurement(point, keypoint, camera, T_map_cam);
}

void LocalMap::describe(PointId id, const core::Keypoint& keypoint, const OrbDescriptor& descriptor,
                        const Eigen::Isometry3d& T_map_cam) {
  describeFrom(at(id), keypoint, descriptor, T_map_cam);
}

/// A loop moves the whole map, of which little is here, and less in sight. An adjustment moves what is around.
void LocalMap::apply(const std::shared_ptr<const MapUpdate>& update, std::uint64_t frame,
                     const Eigen::Matrix3d& R_map_before) {
  if (update->movesTheMap && std::min(points_.size(), update->p_map_m.size()) > kMostAtOnce) {
    putOff_.add(update, R_map_before);
  } else {
    forEachOfBoth(points_, update->p_map_m, [&](PointId id, MapPoint& point, const Eigen::Vector3d& p_map_m) {
      putOff_.settle(id, point);
      moveTo(p_map_m, R_map_before, point);
    });
  }
  recall(*update, frame);  // these are where they belong already
  for (const auto& [from, into] : update->fusedPoints) fuse(from, into);
  for (const PointId id : update->removedPoints) remove(id);
  for (const RemovedKeyframe& removed : update->removedKeyframes) removeKeyframe(removed.id);
}

void LocalMap::movePoints(PointId first, const Eigen::Isometry3d& correction) {
  for (auto point = points_.lower_bound(first); point != points_.end(); ++point) {
    putOff_.settle(point->first, point->second);
    move(point->second, correction);
  }
}

void LocalMap::recall(const MapUpdate& update, std::uint64_t frame) {
  for (const auto& [id, point] : update.recalledPoints) {
    const auto [known, isNew] = points_.try_emplace(id, point);
    if (isNew) putOff_.skip(id);
    known->second.lastSeenFrame = frame;
  }
  for (const auto& [id, points] : update.recalledKeyframes) addKeyframe(id, points);
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
  putOff_.clear();
  points_.clear();
  seenBy_.clear();
  keyframes_.clear();
}

void LocalMap::remove(PointId id) {
  points_.erase(id);
  const auto seenBy = seenBy_.find(id);
  if (seenBy == seenBy_.end()) return;
  for (const KeyframeId keyframe : seenBy->second) {
    const auto seen = keyframes_.find(keyframe);
    seen->second.erase(std::find(seen->second.begin(), seen->second.end(), id));
    if (seen->second.empty()) keyframes_.erase(seen);
  }
  seenBy_.erase(seenBy);
}

void LocalMap::removeKeyframe(KeyframeId id) {
  const auto seen = keyframes_.find(id);
  if (seen == keyframes_.end()) return;
  for (const PointId point : seen->second) {
    auto& seenBy = seenBy_.at(point);
    seenBy.erase(std::find(seenBy.begin(), seenBy.end(), id));
  }
  keyframes_.erase(seen);
}

void LocalMap::fuse(PointId from, PointId into) {
  const auto seenBy = seenBy_.find(from);
  if (seenBy != seenBy_.end()) {
    for (const KeyframeId keyframe : seenBy->second) link(keyframe, keyframes_.at(keyframe), into);
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
}

}  // namespace wardslam::odometry
