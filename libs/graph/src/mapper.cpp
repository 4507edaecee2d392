#include "wardslam/graph/mapper.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <set>

#include "bundle_adjustment.h"
#include "doubles.h"
#include "floors.h"
#include "lookalikes.h"
#include "loop_confirmation.h"
#include "loop_fit.h"
#include "map_motion.h"
#include "overlap.h"
#include "reach.h"
#include "redundancy.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/core/rigid_transform.h"

namespace wardslam::graph {
namespace {

constexpr std::size_t kMostRecalled = 10;  // keyframes in one update: tracking takes it over between two images

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

}  // namespace

Mapper::Mapper(const GraphOptions& options, const odometry::OdometryOptions& odometry)
    : options_(options),
      places_(options.place_recognition),
      verification_(options.loop_verification, odometry.matcher, odometry.pose_solver),
      confirmation_(std::make_unique<LoopConfirmation>(options.loop_confirmation, options.loop_verification)),
      lookalikes_(std::make_unique<Lookalikes>()) {}

Mapper::~Mapper() = default;

void Mapper::restore(const SavedGraph& saved, Saved use) {
  if (saved.keyframes.empty()) return;
  keptMap_ = saved.map;
  pieces_ = odometry::Pieces(saved.map);
  takeIn(saved);
  if (use == Saved::IsHeld) graph_.hold();
  rememberPlacesOf(saved);
}

void Mapper::takeIn(const SavedGraph& saved) {
  for (const auto& keyframe : saved.keyframes) {
    graph_.restore(keyframe, saved.p_map_m);
    pieces_.add(keyframe->id, keyframe->submap);
  }
  for (const auto& keyframe : saved.keyframes) findFloorOf(keyframe->id);
  for (const Loop& loop : saved.loops) {
    const bool isTied = graph_.keyframes().count(loop.older) > 0 && graph_.keyframes().count(loop.newer) > 0;
    if (isTied) loops_.push_back(loop);
  }
}

void Mapper::rememberPlacesOf(const SavedGraph& saved) {
  std::vector<RememberedPlace> places;
  for (const auto& keyframe : saved.keyframes) places.push_back(lastingLooksOf(keyframe->id));
  remember(std::move(places));
}

void Mapper::remember(std::vector<RememberedPlace> places) {
  for (const RememberedPlace& place : places) remember(place);
  places_.build();
  remembered_.push_back(std::move(places));
}

odometry::MapUpdate Mapper::insert(const std::shared_ptr<const odometry::Keyframe>& keyframe,
                                   const std::atomic<bool>* stop) {
  const BundleAdjustmentOptions& adjustment = options_.bundle_adjustment;
  graph_.insert(keyframe);
  pieces_.add(keyframe->id, keyframe->submap);
  findFloorOf(keyframe->id);
  auto update = adjust(graph_, localWindow(graph_, keyframe->id, adjustment), adjustment, adjustment.local_iterations);
  cullPoints(keyframe->id, update);
  if (options_.cull_keyframes) cullKeyframes(keyframe->id, update);
  if (options_.close_loops) {
    rememberPlaces(keyframe->id);
    const auto loops = confirmation_->confirm(graph_, keyframe->id, recognise(keyframe->id, keyframe->id));
    if (!loops.empty() && !areMistakable(loops)) close(loops, stop, update);
  }
  recallAround(keyframe->id, update);
  tellNewest(graph_, keyframe->id, update);
  return update;
}

void Mapper::findFloorOf(KeyframeId id) {
  if (options_.floor) findFloor(graph_, id, static_cast<std::size_t>(options_.bundle_adjustment.min_shared_points));
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
  pieces_.remove(id);
  young_.erase(std::remove(young_.begin(), young_.end(), id), young_.end());
  for (Loop& loop : loops_) rehang(loop, removed);
  confirmation_->apply(removed);
  lookalikes_->apply(removed);
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
    remember(lastingLooksOf(young_.front()));
    young_.pop_front();
  }
  if (startsAnew) places_.build();
  young_.push_back(newest);
}

/// By the looks of points that have lasted: what was seen once will hardly be seen again.
RememberedPlace Mapper::lastingLooksOf(KeyframeId id) const {
  RememberedPlace place{id, {}};
  for (const auto& [point, keypoint] : graph_.keyframes().at(id).keypointOf)
    place.keypoints.push_back(static_cast<std::uint32_t>(keypoint));
  return place;
}

void Mapper::remember(const RememberedPlace& place) {
  const cv::Mat& all = graph_.keyframes().at(place.id).keyframe->features.descriptors;
  cv::Mat descriptors;
  for (const std::uint32_t keypoint : place.keypoints) descriptors.push_back(all.row(static_cast<int>(keypoint)));
  places_.add(place.id, descriptors);
}

/// Among the keyframes before that one.
std::vector<Loop> Mapper::recognise(KeyframeId newest, KeyframeId before) {
  std::set<KeyframeId> known{newest};
  for (const auto& [id, shared] : graph_.covisible(newest)) known.insert(id);
  std::vector<KeyframeId> candidates = confirmation_->expected(graph_, newest);
  const std::size_t mostPlaces =
      candidates.size() + static_cast<std::size_t>(options_.place_recognition.max_candidates);
  std::size_t places = 0;
  const auto& features = graph_.keyframes().at(newest).keyframe->features;
  for (const KeyframeId alike : places_.candidates(features, known)) candidates.push_back(alike);
  std::vector<Loop> seen;
  for (const KeyframeId candidate : candidates) {
    if (candidate >= before || known.count(candidate) != 0) continue;
    const auto place = verification_.placeAround(graph_, candidate);
    const bool isTiedAlready =
        std::any_of(place.begin(), place.end(), [&](KeyframeId id) { return known.count(id) != 0; });
    known.insert(place.begin(), place.end());
    if (isTiedAlready) continue;
    if (++places > mostPlaces) break;
    auto loop = verification_.look(graph_, newest, place);
    if (loop && isBelievable(*loop)) seen.push_back(std::move(*loop));
  }
  return seen;
}

/// What looks the same and cannot be is worth knowing.
bool Mapper::isBelievable(const Loop& loop) {
  if (verification_.isPlausible(graph_, loop, loops_)) return !lookalikes_->areMistakable(graph_, loop);
  const bool isOfOnePiece = graph_.keyframes().at(loop.older).submap == graph_.keyframes().at(loop.newer).submap;
  lookalikes_->add(loop, verification_.placeAround(graph_, loop.newer),
                   isOfOnePiece ? correction_m(graph_, loop) : std::numeric_limits<double>::infinity());
  return false;
}

bool Mapper::areMistakable(const std::vector<Loop>& loops) {
  const auto isMistakable = [this](const Loop& loop) { return lookalikes_->areMistakable(graph_, loop); };
  if (std::any_of(loops.begin(), loops.end(), isMistakable)) return true;
  const Loop& newest = loops.front();
  const bool joins = graph_.keyframes().at(newest.older).submap != graph_.keyframes().at(newest.newer).submap;
  return joins && !ambiguity_m(graph_, newest, options_.loop_verification) && hasDouble(newest);
}

/// Of a run's way into an earlier map nothing is known. But the map itself tells what else looks like the place.
bool Mapper::hasDouble(const Loop& join) {
  for (const KeyframeId id : roomAround(graph_, join.older)) {
    const auto search = [&] { return doublesOf(graph_, id, places_, verification_, options_.place_recognition); };
    const bool isOfPlace = std::find(join.place.begin(), join.place.end(), id) != join.place.end();
    for (const Loop& look : lookalikes_->doublesOf(id, search)) {
      if (!isOfPlace && !confirmation_->isStrong(look)) continue;
      if (verification_.isPlausible(graph_, look, loops_)) continue;
      if (explains(graph_, look, join, verification_, options_.loop_verification)) return true;
    }
  }
  return false;
}

/// Whatever does not fit in the end is taken back whole, before anybody hears of it.
bool Mapper::close(const std::vector<Loop>& loops, const std::atomic<bool>* stop, odometry::MapUpdate& update) {
  std::optional<odometry::MapUpdate> closing;
  if (agreesInDepth(loops.front())) {
    if (leavesTheSettled(loops.front())) closing = closeWith(loops, Bent::TheUnsettled, stop);
    if (!closing) closing = closeWith(loops, Bent::All, stop);
  }
  if (!closing) {
    ++loopsTakenBack_;
    return false;
  }
  ++loopsClosed_;
  if (closing->joined) joins_.push_back(*closing->joined);
  update.movesTheMap = true;
  update.joined = closing->joined;
  update.seenAgain = {loops.front().older, loops.front().newer, loops.front().T_older_newer};
  update.fusedPoints = std::move(closing->fusedPoints);
  update.removedPoints.insert(update.removedPoints.end(), closing->removedPoints.begin(), closing->removedPoints.end());
  update.p_map_m.clear();  // with them the points fused away
  describe(graph_, graph_.keyframes().at(loops.front().newer).submap, update);
  for (const Loop& loop : loops) {
    for (const KeyframeId id : loop.place) {
      if (graph_.keyframes().count(id) != 0) recall(id, update);
    }
  }
  return true;
}

/// Whether there is anything settled, and a loop may do without bending it.
bool Mapper::leavesTheSettled(const Loop& loop) const {
  if (options_.pose_graph.solver == PoseGraphSolver::Levmarq) return false;  // holds nothing still
  const std::uint32_t older = graph_.keyframes().at(loop.older).submap;
  const std::uint32_t newer = graph_.keyframes().at(loop.newer).submap;
  if (!graph_.isAnySettled(older) && !graph_.isAnySettled(newer)) return false;
  return older != newer || verification_.leavesTheSettled(graph_, loop, loops_);
}

/// What it joined, fused and removed; nothing where it does not fit: then all is as before.
std::optional<odometry::MapUpdate> Mapper::closeWith(const std::vector<Loop>& loops, Bent bent,
                                                     const std::atomic<bool>* stop) {
  graph_.beginTrial();
  const odometry::Pieces piecesBefore = pieces_;
  const std::size_t loopsBefore = loops_.size();
  Held held{{}, misfitsOf(graph_, loops_)};
  loops_.insert(loops_.end(), loops.begin(), loops.end());
  odometry::MapUpdate closing;
  closing.joined = joinSubmaps(loops.front());
  const std::uint32_t piece = graph_.keyframes().at(loops.front().newer).submap;
  if (bent == Bent::All) graph_.unsettle(piece);
  held.steps = tiedSteps(graph_, piece, options_.pose_graph.min_shared_points);
  optimisePoses(graph_, piece, loops_, options_.pose_graph);
  for (const Loop& loop : loops) fuse(loop, closing);
  const BundleAdjustmentOptions& adjustment = options_.bundle_adjustment;
  auto adjusted = adjust(graph_, globalWindow(graph_, piece), adjustment, adjustment.global_iterations, stop);
  if (!fit(graph_, held, loops_, options_.loop_confirmation)) {
    graph_.takeBack();
    pieces_ = piecesBefore;
    loops_.resize(loopsBefore);
    return std::nullopt;
  }
  graph_.endTrial();
  closing.removedPoints = std::move(adjusted.removedPoints);
  return closing;
}

/// All that two pieces saw of each other's surfaces, and not only where they were found to meet, must be there.
bool Mapper::agreesInDepth(const Loop& join) const {
  const KeyframeNode& older = graph_.keyframes().at(join.older);
  const KeyframeNode& newer = graph_.keyframes().at(join.newer);
  if (older.submap == newer.submap) return true;
  const Eigen::Isometry3d T_older_newer = older.T_map_cam * join.T_older_newer * newer.T_map_cam.inverse();
  const auto agreement = depthAcross(graph_, newer.submap, older.submap, T_older_newer);
  return agreement.contradiction() <= options_.loop_verification.max_contradiction;
}

std::optional<odometry::MapUpdate> Mapper::settle() {
  if (graph_.keyframes().empty() || !options_.close_loops) return std::nullopt;
  const auto isRefused = [this](const Loop& loop) {
    return lookalikes_->areMistakable(graph_, loop) || !verification_.isPlausible(graph_, loop, loops_);
  };
  for (auto loops = confirmation_->settle(graph_, isRefused); !loops.empty();
       loops = confirmation_->settle(graph_, isRefused)) {
    odometry::MapUpdate update;
    if (areMistakable(loops) || !close(loops, nullptr, update)) continue;
    tellNewest(graph_, graph_.keyframes().rbegin()->first, update);
    return update;
  }
  return std::nullopt;
}

/// The map of an earlier run keeps its frame, else the piece begun first does.
odometry::SubmapJoin Mapper::directionOf(std::uint32_t piece, std::uint32_t other) const {
  const auto [first, second] = std::minmax(piece, other);
  if (keptMap_ == second) return {first, second};
  return {second, first};
}

std::optional<odometry::SubmapJoin> Mapper::joinSubmaps(const Loop& loop) {
  const KeyframeNode& older = graph_.keyframes().at(loop.older);
  const KeyframeNode& newer = graph_.keyframes().at(loop.newer);
  if (older.submap == newer.submap) return std::nullopt;
  const odometry::SubmapJoin join = directionOf(older.submap, newer.submap);
  Eigen::Isometry3d T_into_from = core::rigid(older.T_map_cam * loop.T_older_newer * newer.T_map_cam.inverse());
  if (join.into == newer.submap) T_into_from = T_into_from.inverse();
  std::map<KeyframeId, Eigen::Isometry3d> T_map_cam;
  for (const auto& [id, node] : graph_.keyframes()) {
    if (node.submap == join.from) T_map_cam[id] = T_into_from * node.T_map_cam;
  }
  moveKeyframes(graph_, T_map_cam);
  graph_.joinSubmaps(join.from, join.into);
  pieces_.join(join);
  return join;
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
/// comes near, it is told; of a place that many keyframes show a few at a time, those first that see most of the same.
void Mapper::recallAround(KeyframeId newest, odometry::MapUpdate& update) {
  std::vector<KeyframeId> around;
  std::set<KeyframeId> known{newest};
  const auto addNeighboursOf = [&](KeyframeId keyframe) {
    for (const auto& [id, shared] : graph_.covisible(keyframe)) {
      if (shared < static_cast<std::size_t>(options_.bundle_adjustment.min_shared_points)) break;
      if (known.insert(id).second) around.push_back(id);
    }
  };
  addNeighboursOf(newest);
  for (const KeyframeId id : std::vector<KeyframeId>(around)) addNeighboursOf(id);
  const auto gap = static_cast<KeyframeId>(options_.place_recognition.min_keyframe_gap);
  std::set<KeyframeId> told;
  std::size_t news = 0;
  for (const KeyframeId id : around) {
    const bool isKnown = id + gap > newest || around_.count(id) != 0;
    if (!isKnown && ++news > kMostRecalled) continue;
    if (!isKnown) recall(id, update);
    told.insert(id);
  }
  around_ = std::move(told);
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
