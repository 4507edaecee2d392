#include "wardslam/graph/mapper.h"

#include <algorithm>
#include <functional>
#include <set>

#include "bundle_adjustment.h"
#include "pose_graph.h"
#include "redundancy.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::graph {
namespace {

/// Moves keyframes to new poses; every point goes with the first keyframe that saw it.
void moveKeyframes(KeyframeGraph& graph, const std::map<KeyframeId, Eigen::Isometry3d>& T_map_cam) {
  std::map<PointId, Eigen::Vector3d> positions_m;
  for (const auto& [id, node] : graph.points()) {
    const KeyframeId reference = *node.seenBy.begin();
    const auto moved = T_map_cam.find(reference);
    if (moved == T_map_cam.end()) continue;
    const Eigen::Isometry3d correction = moved->second * graph.keyframes().at(reference).T_map_cam.inverse();
    positions_m[id] = correction * node.point.p_map_m;
  }
  for (const auto& [id, p_map_m] : positions_m) graph.setPosition(id, p_map_m);
  for (const auto& [id, pose] : T_map_cam) graph.setPose(id, pose);
}

/// The whole submap as tracking should know it; what is held is where it always was.
void describe(const KeyframeGraph& graph, std::uint32_t submap, odometry::MapUpdate& update) {
  for (const auto& [id, node] : graph.keyframes()) {
    if (node.submap != submap || node.isHeld) continue;
    update.T_map_cam[id] = node.T_map_cam;
    for (const auto& [point, keypoint] : node.keypointOf) {
      update.p_map_m[point] = graph.points().at(point).point.p_map_m;
    }
  }
}

/// Up to where the map was known; what is younger moves as this keyframe does.
void tellNewest(const KeyframeGraph& graph, KeyframeId newest, odometry::MapUpdate& update) {
  const KeyframeNode& node = graph.keyframes().at(newest);
  update.newestKeyframe = newest;
  update.submap = node.keyframe->submap;
  update.T_map_cam[newest] = node.T_map_cam;
}

/// The loop as it is when what hung on the removed keyframe hangs on its heir.
void rehang(Loop& loop, const odometry::RemovedKeyframe& removed) {
  if (loop.older == removed.id) {
    loop.older = removed.heir;
    loop.T_older_newer = removed.T_heir_cam * loop.T_older_newer;
  }
  if (loop.newer == removed.id) {
    loop.newer = removed.heir;
    loop.T_older_newer = loop.T_older_newer * removed.T_heir_cam.inverse();
  }
}

}  // namespace

Mapper::Mapper(const GraphOptions& options, const odometry::OdometryOptions& odometry)
    : options_(options),
      places_(options.place_recognition),
      verification_(options.loop_verification, odometry.matcher, odometry.pose_solver) {}

void Mapper::restore(const SavedGraph& saved, Saved use) {
  for (const auto& keyframe : saved.keyframes) {
    graph_.restore(keyframe, saved.p_map_m);
    rememberPlace(keyframe->id);
  }
  if (use == Saved::IsHeld) graph_.hold();
  places_.build();
}

odometry::MapUpdate Mapper::insert(const std::shared_ptr<const odometry::Keyframe>& keyframe,
                                   const std::atomic<bool>* stop) {
  const BundleAdjustmentOptions& adjustment = options_.bundle_adjustment;
  graph_.insert(keyframe);
  auto update = adjust(graph_, localWindow(graph_, keyframe->id, adjustment), adjustment, adjustment.local_iterations);
  cullPoints(keyframe->id, update);
  if (options_.cull_keyframes) cullKeyframes(keyframe->id, update);
  if (options_.close_loops) {
    rememberPlaces(keyframe->id);
    if (const auto loop = recognise(keyframe->id)) close(*loop, stop, update);
  }
  recallAround(keyframe->id, update);
  tellNewest(graph_, keyframe->id, update);
  return update;
}

void Mapper::cullPoints(KeyframeId newest, odometry::MapUpdate& update) {
  for (const auto& [point, keypoint] : graph_.keyframes().at(newest).keypointOf) {
    if (*graph_.points().at(point).seenBy.begin() == newest) onProbation_.emplace(newest, point);
  }
  const KeyframeId probation = static_cast<KeyframeId>(options_.probation_keyframes);
  while (!onProbation_.empty() && onProbation_.begin()->first + probation <= newest) {
    const auto [keyframe, point] = *onProbation_.begin();
    onProbation_.erase(onProbation_.begin());
    const auto node = graph_.points().find(point);
    if (node == graph_.points().end() || node->second.seenBy.size() > 1) continue;
    graph_.removeSighting(*node->second.seenBy.begin(), point);
    update.removedPoints.push_back(point);
  }
}

/// Of what shows the same, the older stays: more hangs on it.
void Mapper::cullKeyframes(KeyframeId newest, odometry::MapUpdate& update) {
  const std::uint32_t submap = graph_.keyframes().at(newest).submap;
  const auto& keyframes = graph_.keyframes();
  const KeyframeId first =
      std::find_if(keyframes.begin(), keyframes.end(), [&](const auto& k) { return k.second.submap == submap; })->first;
  std::set<KeyframeId, std::greater<>> candidates;
  for (const auto& [id, shared] : graph_.covisible(newest)) {
    const bool isYoung = id + static_cast<KeyframeId>(options_.probation_keyframes) >= newest;
    if (!isYoung && id != first && !isHeld(id)) candidates.insert(id);
  }
  for (const KeyframeId id : candidates) {
    if (isRedundant(graph_, id, options_.redundancy)) remove(id, update);
  }
}

void Mapper::remove(KeyframeId id, odometry::MapUpdate& update) {
  const auto removed = heirOf(graph_, id);
  const auto sightings = graph_.keyframes().at(id).keypointOf;
  const auto points = graph_.remove(id);
  update.T_map_cam.erase(id);
  update.removedKeyframes.push_back(removed);
  update.removedPoints.insert(update.removedPoints.end(), points.begin(), points.end());
  for (const auto& [point, keypoint] : sightings) {
    const auto node = graph_.points().find(point);
    const bool isSeenOnce = node != graph_.points().end() && !node->second.isHeld && node->second.seenBy.size() == 1;
    if (isSeenOnce) onProbation_.emplace(*node->second.seenBy.begin(), point);
  }
  places_.remove(id);
  young_.erase(std::remove(young_.begin(), young_.end(), id), young_.end());
  for (Loop& loop : loops_) rehang(loop, removed);
  const auto tiesNothing = [](const Loop& loop) { return loop.older == loop.newer; };
  loops_.erase(std::remove_if(loops_.begin(), loops_.end(), tiesNothing), loops_.end());
}

odometry::MapUpdate Mapper::adjustAll() {
  odometry::MapUpdate update;
  if (graph_.keyframes().empty()) return update;
  std::set<std::uint32_t> submaps;
  for (const auto& [id, node] : graph_.keyframes()) submaps.insert(node.submap);
  const BundleAdjustmentOptions& adjustment = options_.bundle_adjustment;
  for (const std::uint32_t submap : submaps) {
    const auto adjusted = adjust(graph_, globalWindow(graph_, submap), adjustment, adjustment.global_iterations);
    const auto& removed = adjusted.removedPoints;
    update.removedPoints.insert(update.removedPoints.end(), removed.begin(), removed.end());
    describe(graph_, submap, update);
  }
  tellNewest(graph_, graph_.keyframes().rbegin()->first, update);
  return update;
}

/// A place can be recognised some keyframes after it was left, or at once when tracking starts anew.
void Mapper::rememberPlaces(KeyframeId newest) {
  const auto submapOf = [this](KeyframeId id) { return graph_.keyframes().at(id).keyframe->submap; };
  const bool startsAnew = !young_.empty() && submapOf(young_.back()) != submapOf(newest);
  const auto gap = static_cast<std::size_t>(startsAnew ? 0 : options_.place_recognition.min_keyframe_gap);
  while (young_.size() > gap) {
    rememberPlace(young_.front());
    young_.pop_front();
  }
  if (startsAnew) places_.build();
  young_.push_back(newest);
}

/// By the looks of points that have lasted: what was seen once will hardly be seen again.
void Mapper::rememberPlace(KeyframeId id) {
  const KeyframeNode& node = graph_.keyframes().at(id);
  cv::Mat descriptors;
  for (const auto& [point, keypoint] : node.keypointOf)
    descriptors.push_back(node.keyframe->features.descriptors.row(static_cast<int>(keypoint)));
  places_.add(id, descriptors);
}

std::optional<Loop> Mapper::recognise(KeyframeId newest) const {
  std::set<KeyframeId> known{newest};
  for (const auto& [id, shared] : graph_.covisible(newest)) known.insert(id);
  const auto& features = graph_.keyframes().at(newest).keyframe->features;
  for (const KeyframeId candidate : places_.candidates(features, known)) {
    if (known.count(candidate) != 0) continue;
    const auto place = verification_.placeAround(graph_, candidate);
    const bool isTiedAlready =
        std::any_of(place.begin(), place.end(), [&](KeyframeId id) { return known.count(id) != 0; });
    known.insert(place.begin(), place.end());
    if (isTiedAlready) continue;
    if (auto loop = verification_.verify(graph_, newest, place)) return loop;
  }
  return std::nullopt;
}

void Mapper::close(const Loop& loop, const std::atomic<bool>* stop, odometry::MapUpdate& update) {
  loops_.push_back(loop);
  ++loopsClosed_;
  update.joined = joinSubmaps(loop);
  const std::uint32_t submap = graph_.keyframes().at(loop.newer).submap;
  optimisePoses(submap);
  fuse(loop, update);
  const BundleAdjustmentOptions& adjustment = options_.bundle_adjustment;
  const auto adjusted = adjust(graph_, globalWindow(graph_, submap), adjustment, adjustment.global_iterations, stop);
  update.removedPoints.insert(update.removedPoints.end(), adjusted.removedPoints.begin(), adjusted.removedPoints.end());
  update.p_map_m.clear();  // with them the points fused away
  describe(graph_, submap, update);
  for (const KeyframeId id : loop.place) recall(id, update);
}

std::optional<odometry::SubmapJoin> Mapper::joinSubmaps(const Loop& loop) {
  const KeyframeNode& older = graph_.keyframes().at(loop.older);
  const KeyframeNode& newer = graph_.keyframes().at(loop.newer);
  if (older.submap == newer.submap) return std::nullopt;
  const std::uint32_t from = newer.submap;
  const Eigen::Isometry3d T_older_newerMap = older.T_map_cam * loop.T_older_newer * newer.T_map_cam.inverse();
  std::map<KeyframeId, Eigen::Isometry3d> T_map_cam;
  for (const auto& [id, node] : graph_.keyframes()) {
    if (node.submap == from) T_map_cam[id] = T_older_newerMap * node.T_map_cam;
  }
  moveKeyframes(graph_, T_map_cam);
  graph_.joinSubmaps(from, older.submap);
  ++submapsJoined_;
  return odometry::SubmapJoin{from, older.submap};
}

void Mapper::optimisePoses(std::uint32_t submap) {
  PoseGraph poses = makePoseGraph(graph_, submap, loops_, options_.pose_graph);
  std::set<std::pair<KeyframeId, KeyframeId>> loopEdges;
  for (const Loop& loop : loops_) loopEdges.emplace(loop.older, loop.newer);
  std::set<KeyframeId> held;
  for (const auto& [id, pose] : poses.nodes) {
    if (isHeld(id)) held.insert(id);
  }
  optimise(poses, loopEdges, held, options_.pose_graph);
  std::map<KeyframeId, Eigen::Isometry3d> T_map_cam;
  for (const auto& [id, pose] : poses.nodes) {
    if (held.count(id) == 0) T_map_cam[id] = core::fromMrpt(pose);
  }
  moveKeyframes(graph_, T_map_cam);
}

void Mapper::fuse(const Loop& loop, odometry::MapUpdate& update) {
  for (const auto& [from, into] : loop.samePoints) {
    if (graph_.points().count(from) == 0 || graph_.points().count(into) == 0) continue;
    if (graph_.points().at(from).isHeld) continue;
    graph_.fuse(from, into);
    update.fusedPoints[from] = into;
  }
}

/// Tracking forgets what it has not seen for long, and of what a loop ties on it knows one place only: as a known place
/// comes near, it is told.
void Mapper::recallAround(KeyframeId newest, odometry::MapUpdate& update) {
  std::set<KeyframeId> around;
  const auto addNeighboursOf = [&](KeyframeId keyframe) {
    for (const auto& [id, shared] : graph_.covisible(keyframe)) {
      if (shared >= static_cast<std::size_t>(options_.bundle_adjustment.min_shared_points)) around.insert(id);
    }
  };
  addNeighboursOf(newest);
  for (const KeyframeId id : std::set<KeyframeId>(around)) addNeighboursOf(id);
  const auto gap = static_cast<KeyframeId>(options_.place_recognition.min_keyframe_gap);
  for (const KeyframeId id : around) {
    const bool isJustMade = id + gap > newest;
    if (!isJustMade && around_.count(id) == 0) recall(id, update);
  }
  around_ = std::move(around);
}

void Mapper::recall(KeyframeId id, odometry::MapUpdate& update) const {
  auto& points = update.recalledKeyframes[id];
  points.clear();
  for (const auto& [point, keypoint] : graph_.keyframes().at(id).keypointOf) {
    points.push_back(point);
    update.recalledPoints.emplace(point, graph_.points().at(point).point);
  }
}

}  // namespace wardslam::graph
