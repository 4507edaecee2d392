#include "wardslam/graph/keyframe_graph.h"

#include <algorithm>

namespace wardslam::graph {
namespace {

/// As if the image had measured how far away the point is that is known to lie there.
core::Keypoint withDepthOf(const Eigen::Vector3d& p_map_m, core::Keypoint keypoint,
                           const Eigen::Isometry3d& T_map_cam) {
  keypoint.depth_m = static_cast<float>((T_map_cam.inverse() * p_map_m).z());
  return keypoint;
}

}  // namespace

void KeyframeGraph::insert(const std::shared_ptr<const odometry::Keyframe>& keyframe) {
  const auto previous = keyframes_.find(keyframe->id - 1);
  const bool follows =
      keyframe->T_previous_cam && previous != keyframes_.end() && previous->second.submap == currentSubmapOf(*keyframe);
  insertAt(keyframe, follows ? previous->second.T_map_cam * *keyframe->T_previous_cam : keyframe->T_map_cam, {});
}

void KeyframeGraph::restore(const std::shared_ptr<const odometry::Keyframe>& keyframe,
                            const std::map<PointId, Eigen::Vector3d>& p_map_m) {
  insertAt(keyframe, keyframe->T_map_cam, p_map_m);
  KeyframeNode& node = keyframes_.at(keyframe->id);
  node.isRestored = node.isSettled = true;
  for (const auto& [point, keypoint] : node.keypointOf) {
    if (const auto known = p_map_m.find(point); known != p_map_m.end()) setPosition(point, known->second);
  }
}

void KeyframeGraph::hold() {
  for (auto& [id, node] : keyframes_) {
    node.isHeld = true;
    node.isSettled = false;
  }
  for (auto& [id, node] : points_) node.isHeld = true;
}

bool KeyframeGraph::isAnySettled(std::uint32_t submap) const {
  return std::any_of(keyframes_.begin(), keyframes_.end(), [submap](const auto& keyframe) {
    return keyframe.second.submap == submap && keyframe.second.isSettled;
  });
}

void KeyframeGraph::unsettle(std::uint32_t submap) {
  for (auto& [id, node] : keyframes_) {
    if (node.submap == submap) unsettle(id, node);
  }
}

void KeyframeGraph::unsettle(KeyframeId id, KeyframeNode& node) {
  if (trial_ && node.isSettled) trial_->settled.insert(id);
  node.isSettled = false;
}

/// A point is made where it is known to lie, or from the key point's depth.
void KeyframeGraph::insertAt(const std::shared_ptr<const odometry::Keyframe>& keyframe,
                             const Eigen::Isometry3d& T_map_cam, const std::map<PointId, Eigen::Vector3d>& p_map_m) {
  KeyframeNode node{keyframe, T_map_cam, {}, currentSubmapOf(*keyframe)};
  for (const auto& [seenAs, keypointIndex] : keyframe->sightings) {
    const PointId id = currentIdOf(seenAs);
    core::Keypoint keypoint = keyframe->features.keypoints[keypointIndex];
    const auto descriptor = odometry::descriptorOf(keyframe->features, keypointIndex);
    const auto known = points_.find(id);
    const auto place = p_map_m.find(id);
    if (!keypoint.hasDepth() && place != p_map_m.end()) keypoint = withDepthOf(place->second, keypoint, T_map_cam);
    if (known != points_.end()) {
      odometry::describeFrom(known->second.point, keypoint, descriptor, node.T_map_cam);
      if (known->second.seenBy.insert(keyframe->id).second) countShared(keyframe->id, known->second.seenBy, 1);
    } else if (keypoint.hasDepth()) {
      points_[id] = {
          odometry::makeMapPoint(keypoint, descriptor, keyframe->camera, node.T_map_cam), {keyframe->id}, false};
    } else {
      continue;  // was removed meanwhile, and this image cannot tell where it is
    }
    node.keypointOf.emplace(id, keypointIndex);
  }
  keyframes_.emplace(keyframe->id, std::move(node));
}

std::vector<std::pair<KeyframeId, std::size_t>> KeyframeGraph::covisible(KeyframeId id) const {
  const auto shared = shared_.find(id);
  if (shared == shared_.end()) return {};
  std::vector<std::pair<KeyframeId, std::size_t>> neighbours(shared->second.begin(), shared->second.end());
  std::stable_sort(neighbours.begin(), neighbours.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return neighbours;
}

void KeyframeGraph::countShared(KeyframeId id, const std::set<KeyframeId>& seenBy, int change) {
  const auto count = [&](KeyframeId of, KeyframeId with) {
    keepShared(of);
    const auto points = shared_[of].try_emplace(with, 0).first;
    points->second += static_cast<std::size_t>(change);
    if (points->second == 0) shared_[of].erase(points);
  };
  for (const KeyframeId other : seenBy) {
    if (other == id) continue;
    count(id, other);
    count(other, id);
  }
}

void KeyframeGraph::countAllShared() {
  shared_.clear();
  for (const auto& [point, node] : points_) {
    std::set<KeyframeId> seenBy;
    for (const KeyframeId id : node.seenBy) {
      countShared(id, seenBy, 1);
      seenBy.insert(id);
    }
  }
}

void KeyframeGraph::setPose(KeyframeId id, const Eigen::Isometry3d& T_map_cam) {
  KeyframeNode& node = keyframes_.at(id);
  if (trial_) trial_->T_map_cam.emplace(id, node.T_map_cam);
  node.T_map_cam = T_map_cam;
}

void KeyframeGraph::setPosition(PointId id, const Eigen::Vector3d& p_map_m) {
  odometry::MapPoint& point = points_.at(id).point;
  keepPlace(id);
  point.viewedFrom_map_m += p_map_m - point.p_map_m;
  point.p_map_m = p_map_m;
}

void KeyframeGraph::movePoint(PointId id, const Eigen::Isometry3d& correction) {
  odometry::MapPoint& point = points_.at(id).point;
  keepPlace(id);
  odometry::move(point, correction);
}

void KeyframeGraph::removeSighting(KeyframeId keyframe, PointId point) {
  keepSightings(keyframe);
  keep(point);
  keyframes_.at(keyframe).keypointOf.erase(point);
  const auto node = points_.find(point);
  node->second.seenBy.erase(keyframe);
  countShared(keyframe, node->second.seenBy, -1);
  if (node->second.seenBy.empty()) points_.erase(node);
}

std::vector<PointId> KeyframeGraph::remove(KeyframeId id) {
  std::vector<PointId> removedPoints;
  const auto sightings = keyframes_.at(id).keypointOf;
  for (const auto& [point, keypoint] : sightings) {
    removeSighting(id, point);
    if (points_.count(point) == 0) removedPoints.push_back(point);
  }
  keyframes_.erase(id);
  shared_.erase(id);
  return removedPoints;
}

void KeyframeGraph::fuse(PointId from, PointId into) {
  keep(from);
  keep(into);
  if (trial_) trial_->fused.push_back(from);
  std::set<KeyframeId> others = points_.at(from).seenBy;
  for (const KeyframeId id : points_.at(from).seenBy) {
    others.erase(id);
    countShared(id, others, -1);
  }
  for (const KeyframeId id : points_.at(from).seenBy) {
    keepSightings(id);
    auto& keypointOf = keyframes_.at(id).keypointOf;
    const std::size_t keypoint = keypointOf.at(from);
    keypointOf.erase(from);
    if (!keypointOf.emplace(into, keypoint).second) continue;
    countShared(id, points_.at(into).seenBy, 1);
    points_.at(into).seenBy.insert(id);
  }
  points_.erase(from);
  fusedInto_[from] = into;
}

std::uint32_t KeyframeGraph::currentSubmapOf(const odometry::Keyframe& keyframe) const {
  const auto joined = joinedInto_.find(keyframe.submap);
  return joined == joinedInto_.end() ? keyframe.submap : joined->second;
}

PointId KeyframeGraph::currentIdOf(PointId id) const {
  for (auto fused = fusedInto_.find(id); fused != fusedInto_.end(); fused = fusedInto_.find(id)) id = fused->second;
  return id;
}

void KeyframeGraph::joinSubmaps(std::uint32_t from, std::uint32_t into) {
  for (auto& [id, node] : keyframes_) {
    if (node.submap != from) continue;
    if (trial_) trial_->submap.emplace(id, node.submap);
    node.submap = into;
    unsettle(id, node);
  }
  for (auto& [submap, joined] : joinedInto_) {
    if (joined == from) joined = into;
  }
  joinedInto_[from] = into;
}

void KeyframeGraph::beginTrial() {
  trial_.emplace();
  trial_->joinedInto = joinedInto_;
}

void KeyframeGraph::keepSightings(KeyframeId id) {
  if (trial_ && trial_->keypointOf.count(id) == 0) trial_->keypointOf.emplace(id, keyframes_.at(id).keypointOf);
}

void KeyframeGraph::keepShared(KeyframeId id) {
  if (trial_ && trial_->shared.count(id) == 0) trial_->shared.emplace(id, shared_[id]);
}

void KeyframeGraph::keep(PointId id) {
  if (trial_ && trial_->points.count(id) == 0) trial_->points.emplace(id, points_.at(id));
}

void KeyframeGraph::keepPlace(PointId id) {
  if (trial_ && trial_->points.count(id) == 0) trial_->moved.emplace(id, points_.at(id).point);
}

void KeyframeGraph::takeBack() {
  if (!trial_) return;
  Trial before = std::move(*trial_);
  trial_.reset();
  for (const PointId id : before.fused) fusedInto_.erase(id);
  joinedInto_ = std::move(before.joinedInto);
  for (auto& [id, node] : before.points) points_.insert_or_assign(id, std::move(node));
  for (const auto& [id, point] : before.moved) points_.at(id).point = point;
  for (auto& [id, sightings] : before.keypointOf) keyframes_.at(id).keypointOf = std::move(sightings);
  for (auto& [id, shared] : before.shared) shared_[id] = std::move(shared);
  for (const auto& [id, submap] : before.submap) keyframes_.at(id).submap = submap;
  for (const KeyframeId id : before.settled) keyframes_.at(id).isSettled = true;
  for (const auto& [id, T_map_cam] : before.T_map_cam) keyframes_.at(id).T_map_cam = T_map_cam;
}

}  // namespace wardslam::graph
