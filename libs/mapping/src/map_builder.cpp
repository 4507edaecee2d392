#include "wardslam/mapping/map_builder.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "free_fan.h"
#include "known_ground.h"
#include "looks_between_runs.h"
#include "map_part.h"
#include "placed_keyframes.h"
#include "recognition.h"
#include "same_things.h"
#include "semantic_cloud.h"
#include "shown_tile.h"
#include "things_in_hands.h"
#include "usable_pixels.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/view_rays.h"
#include "wardslam/odometry/pieces.h"

namespace wardslam::mapping {
namespace {

/// A class not seen says less than a class seen: networks miss things more often than they see what is not there.
constexpr float kUnclassifiedWeight = 0.25F;

/// One record of two, when it is more probable than all else together.
constexpr double kSurelyOne = 0.5;

constexpr double kRounding = 1e-9;  // of products of poses

}  // namespace

class MapBuilder::Impl {
 public:
  Impl(const MappingOptions& options, MapSetting setting) : options_(options), setting_(std::move(setting)) {}

  void restore(const SemanticMap& earlier, const MapMemory& memory);
  void addKeyframe(const odometry::Keyframe& keyframe);
  void apply(const odometry::MapUpdate& update);
  void add(const View& view);
  void compareRuns(const Views& views, const odometry::Pieces& joined, const std::function<void()>& onTile);
  SemanticMap map();
  SemanticMap map(const MapParts& parts);
  [[nodiscard]] MapMemory memory(const std::set<KeyframeId>& tiles) const;
  MapParts takeChanges();
  [[nodiscard]] FloorSeen floorSeen() const;

 private:
  Part& part(std::uint32_t piece) { return parts_.try_emplace(piece, options_).first->second; }
  [[nodiscard]] std::string zoneAt(std::uint32_t piece, const Eigen::Vector3d& p_map_m) const;
  [[nodiscard]] MapParts everything(std::uint32_t piece) const;
  void join(const odometry::SubmapJoin& join);
  void tellOfAnotherMap();
  void remove(const odometry::RemovedKeyframe& removed);
  void follow(const std::map<KeyframeId, Eigen::Isometry3d>& T_map_cam);
  const cv::Mat& raysOf(const core::CameraModel& camera);
  std::vector<ObjectId> recogniseObjects(Part& part, const View& view, const Recognition& seen);
  void takeMerges(Part& part);
  void removeGone(Part& part, const std::vector<ObjectId>& gone);
  void refresh();
  void restoreTile(std::uint64_t id, const SemanticMap& earlier, const MapMemory& memory);
  void restoreObjects(const SemanticMap& earlier, const MapMemory& memory);
  void mergeSameBoxes(Part& part);
  void mergeSameThings(Part& part);
  void reuniteMoved(Part& part);
  void describeTouched(Part& part);

  MappingOptions options_;
  MapSetting setting_;
  std::map<KeyframeId, PlacedKeyframe> keyframes_;
  odometry::Pieces pieces_;
  std::map<std::uint32_t, Part> parts_;     ///< By piece.
  std::optional<std::uint32_t> toldAsMap_;  ///< The piece that was the map when changes were taken last.
  ObjectId nextId_ = 1;
  std::vector<std::pair<ObjectId, ObjectId>> sameThings_;  ///< Of pieces that are about to be joined: {from, into}.
  MapParts changes_;
  std::optional<core::CameraModel> raysCamera_;
  cv::Mat rays_;
  std::string planTrouble_;  ///< Of the last map.
};

void MapBuilder::Impl::restore(const SemanticMap& earlier, const MapMemory& memory) {
  if (keyframes_.empty()) {
    pieces_ = odometry::Pieces(earlier.piece);
    toldAsMap_ = earlier.piece;
  }
  for (const auto& [id, keyframe] : earlier.keyframes) {
    keyframes_[id] = {keyframe.piece, keyframe.stamp_s, keyframe.T_map_cam, keyframe.freeFan_cam_m, keyframe.ground};
    pieces_.add(id, keyframe.piece);
    if (zoneAt(keyframe.piece, keyframe.T_map_cam.translation()) != keyframe.zone) changes_.keyframes.insert(id);
    restoreTile(id, earlier, memory);
  }
  restoreObjects(earlier, memory);
  for (auto& [piece, part] : parts_) {  // the earlier run has written them
    static_cast<void>(part.cloud.takeChanges());
    static_cast<void>(part.cloud.takeChangedObjects());
  }
}

void MapBuilder::Impl::restoreTile(std::uint64_t id, const SemanticMap& earlier, const MapMemory& memory) {
  const MappedKeyframe& keyframe = earlier.keyframes.at(id);
  SemanticCloud& cloud = part(keyframe.piece).cloud;
  const auto known = memory.tiles.find(id);
  const auto shown = earlier.cloud.find(id);
  if (known != memory.tiles.end()) {
    cloud.restore(id, keyframe.T_map_cam, known->second);
  } else {
    cloud.restore(id, keyframe.T_map_cam, shown == earlier.cloud.end() ? SemanticCloudTile{} : shown->second);
  }
}

void MapBuilder::Impl::restoreObjects(const SemanticMap& earlier, const MapMemory& memory) {
  nextId_ = std::max(nextId_, earlier.nextObjectId);
  for (const auto& [id, object] : earlier.objects) {
    Part& home = part(object.piece);
    home.objects.restore(id, ObjectRecord::from(object, options_.objects.min_evidence));
    home.table.restore(object);
    home.described.insert(id);
    if (zoneAt(object.piece, object.centroid_m) != object.zone) changes_.objects.insert(id);
    nextId_ = std::max(nextId_, id + 1);
  }
  for (const auto& [id, object] : memory.objects) {
    part(object.piece).objects.restore(id, ObjectRecord(object));
    nextId_ = std::max(nextId_, id + 1);
  }
  for (auto& [piece, part] : parts_) part.objects.restore(memory.pairs);
}

void MapBuilder::Impl::addKeyframe(const odometry::Keyframe& keyframe) {
  const std::uint32_t piece = pieces_.pieceOf(keyframe.submap);
  pieces_.add(keyframe.id, keyframe.submap);
  const Eigen::Isometry3d T_map_cam = placeOf(keyframe, piece, keyframes_);
  keyframes_[keyframe.id] = {piece, keyframe.stamp_s, T_map_cam, {}, keyframe.ground};
  part(piece).cloud.addTile(keyframe.id, T_map_cam);
  changes_.keyframes.insert(keyframe.id);
}

void MapBuilder::Impl::apply(const odometry::MapUpdate& update) {
  follow(withYounger(update, keyframes_));
  for (const auto& removed : update.removedKeyframes) remove(removed);
  if (update.joined) join(*update.joined);
}

void MapBuilder::Impl::follow(const std::map<KeyframeId, Eigen::Isometry3d>& T_map_cam) {
  for (const auto& [id, pose] : T_map_cam) {
    const auto keyframe = keyframes_.find(id);
    if (keyframe == keyframes_.end() || keyframe->second.T_map_cam.matrix() == pose.matrix()) continue;
    keyframe->second.T_map_cam = pose;
    changes_.keyframes.insert(id);
  }
  for (auto& [piece, part] : parts_) part.touched.merge(part.cloud.movePoses(T_map_cam));
}

/// The heir saw the same floor free. It stands where the graph has it: what that says of the removed one's place, but
/// for rounding, is known, and rounding is no move.
void MapBuilder::Impl::remove(const odometry::RemovedKeyframe& removed) {
  const auto keyframe = keyframes_.find(removed.id);
  const auto heir = keyframes_.find(removed.heir);
  if (keyframe == keyframes_.end() || heir == keyframes_.end()) return;
  Part& part = this->part(keyframe->second.piece);
  const Eigen::Isometry3d T_map_cam = heir->second.T_map_cam * removed.T_heir_cam;
  if (!T_map_cam.isApprox(keyframe->second.T_map_cam, kRounding)) {
    part.touched.merge(part.cloud.movePoses({{removed.id, T_map_cam}}));
  }
  part.cloud.moveTile(removed.id, removed.heir);
  keyframes_.erase(keyframe);
  pieces_.remove(removed.id);
  changes_.keyframes.insert(removed.id);
}

void MapBuilder::Impl::join(const odometry::SubmapJoin& join) {
  for (auto& [id, keyframe] : keyframes_) {
    if (keyframe.piece != join.from) continue;
    keyframe.piece = join.into;
    changes_.keyframes.insert(id);
  }
  pieces_.join(join);
  const auto joining = parts_.find(join.from);
  if (joining == parts_.end()) return;
  Part& into = part(join.into);
  for (const auto& [id, object] : joining->second.objects.objects()) into.touched.insert(id);
  into.touched.merge(joining->second.touched);
  into.cloud.absorb(std::move(joining->second.cloud));
  into.objects.absorb(std::move(joining->second.objects));
  into.table.absorb(std::move(joining->second.table));
  parts_.erase(joining);
  mergeSameThings(into);
}

const cv::Mat& MapBuilder::Impl::raysOf(const core::CameraModel& camera) {
  if (!raysCamera_ || !(*raysCamera_ == camera)) {
    raysCamera_ = camera;
    rays_ = core::viewRays(camera);
  }
  return rays_;
}

void MapBuilder::Impl::add(const View& view) {
  const auto keyframe = keyframes_.find(view.keyframe);
  if (keyframe == keyframes_.end()) return;
  Part& part = this->part(keyframe->second.piece);
  if (view.isKeyframe) {
    const StandingGround ground = lookAtGround(view, keyframes_, keyframe->second);
    keyframe->second.freeFan_cam_m = freeFan(view.depth_m, view.camera, ground, options_.floor_plan);
  }
  const Eigen::Isometry3d T_map_cam = keyframe->second.T_map_cam * view.T_keyframe_cam;
  const auto cell_m = static_cast<float>(options_.cloud.voxel_m);

  const auto look = part.cloud.look(view.camera, T_map_cam, view.depth_m, nearestAround(view.depth_m));
  removeGone(part, part.objects.erase(look.erased, part.cloud.pointCounts(), view.stamp_s));
  const cv::Mat usable = usablePixels(view, setting_.moving, options_.cloud);
  const auto samples = sampleView(view, T_map_cam, raysOf(view.camera), usable, cell_m, options_.cloud.pixel_step);
  const auto points = part.cloud.recognise(samples, T_map_cam.translation());
  const auto detections = detect(view.segmentation, samples, setting_.moving, options_.objects, cell_m);
  for (const Handled& thing : thingsInHands(view, setting_.moving)) {
    const Eigen::Vector3f place_m = (T_map_cam * thing.p_cam_m).cast<float>();
    part.objects.noteHandled(thing.classId, place_m, view.stamp_s);
  }
  const auto objects = recogniseObjects(part, view, {samples, points, detections, look.inSight});

  std::vector<SemanticCloud::LabelVote> votes(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!view.segmentation.empty() && samples[i].instance == 0) votes[i].weight = kUnclassifiedWeight;
  }
  for (std::size_t d = 0; d < detections.size(); ++d) {
    for (const std::size_t i : detections[d].samples) votes[i] = {objects[d], detections[d].confidence};
  }
  part.cloud.fuse(samples, points, votes, view.keyframe);
  takeMerges(part);
  for (const auto& [id, count] : look.inSight) part.touched.insert(id);
  for (const auto& [id, count] : look.erased) part.touched.insert(id);
  part.touched.insert(objects.begin(), objects.end());
}

std::vector<ObjectId> MapBuilder::Impl::recogniseObjects(Part& part, const View& view, const Recognition& seen) {
  const auto evidence = evidenceOf(seen, part.cloud, setting_.movable, options_.cloud.max_range_m);
  const bool canMiss = !view.segmentation.empty();
  return part.objects.observe(evidence, canMiss ? seen.inSight : std::map<ObjectId, std::size_t>{}, view.stamp_s,
                              nextId_);
}

/// Which things are one is found out before points of both become one, and are of one of them.
void MapBuilder::Impl::compareRuns(const Views& views, const odometry::Pieces& joined,
                                   const std::function<void()>& onTile) {
  const LooksByPiece looks = looksOf(views, keyframes_);
  for (auto& [piece, part] : parts_) {
    describeTouched(part);  // what is gone keeps the place it had
    const double until_s = lastStampOf(piece, keyframes_);
    removeGone(part, compareWith(looksOfOthers(piece, looks, joined), part, until_s, onTile));
    describeTouched(part);
  }
  sameThings_ = sameThingsOf(parts_, joined, options_);
}

void MapBuilder::Impl::mergeSameThings(Part& part) {
  for (const auto& [from, into] : sameThings_) part.objects.merge(from, into);
  takeMerges(part);
}

void MapBuilder::Impl::takeMerges(Part& part) {
  for (const auto& [from, into] : part.objects.takeMerges()) {
    part.cloud.renameObject(from, into);
    part.touched.insert({from, into});
  }
}

void MapBuilder::Impl::removeGone(Part& part, const std::vector<ObjectId>& gone) {
  for (const ObjectId id : gone) {
    part.cloud.eraseObject(id);
    part.touched.insert(id);
  }
}

void MapBuilder::Impl::refresh() {
  for (auto& [piece, part] : parts_) {
    if (part.touched.empty()) continue;
    describeTouched(part);
    mergeSameBoxes(part);
    reuniteMoved(part);
    describeTouched(part);
  }
}

void MapBuilder::Impl::describeTouched(Part& part) {
  takeMerges(part);
  const auto touched = std::exchange(part.touched, {});
  const auto classOf = [&part](ObjectId id) {
    const auto row = part.table.rows().find(id);
    return row == part.table.rows().end() ? std::nullopt : std::optional(row->second.classId);
  };
  std::map<ObjectId, std::optional<core::ClassId>> before;
  for (const ObjectId id : touched) before[id] = classOf(id);
  const auto changed = part.table.update(touched, part.objects, part.cloud);
  for (const ObjectId id : changed) {
    if (before.at(id) != classOf(id)) part.cloud.touchObject(id);
  }
  part.described.insert(touched.begin(), touched.end());
  changes_.objects.insert(changed.begin(), changed.end());
}

void MapBuilder::Impl::mergeSameBoxes(Part& part) {
  const auto described = std::exchange(part.described, {});  // others are as they were when last compared
  for (const auto& [from, into] : sameBoxes(described, part.table, part.objects, options_.cloud.voxel_m)) {
    part.objects.merge(from, into);
  }
}

void MapBuilder::Impl::reuniteMoved(Part& part) {
  std::map<ObjectId, MaybeSame> hints;
  for (const auto& pair : reappearances(part.table, part.objects, setting_.movable, options_.objects)) {
    if (pair.isWitnessed && pair.probability > kSurelyOne) {
      removeGone(part, {pair.lost});
      part.touched.insert({pair.lost, pair.found});
      part.objects.reunite(pair.lost, pair.found);
      continue;
    }
    MaybeSame& hint = hints[pair.found];
    if (pair.probability > hint.probability) hint = {pair.lost, pair.probability};
  }
  changes_.objects.merge(part.table.hint(hints));
}

MapParts MapBuilder::Impl::everything(std::uint32_t piece) const {
  MapParts all;
  for (const auto& [id, keyframe] : keyframes_) {
    if (keyframe.piece == piece) all.keyframes.insert(id);
  }
  all.tiles = all.keyframes;
  const auto part = parts_.find(piece);
  if (part == parts_.end()) return all;
  for (const auto& [id, object] : part->second.table.rows()) all.objects.insert(id);
  return all;
}

SemanticMap MapBuilder::Impl::map() {
  for (auto& [piece, part] : parts_) part.touched.merge(part.cloud.takeChangedObjects());  // small corrections, too
  refresh();
  const auto piece = pieces_.map();
  SemanticMap map = this->map(piece ? everything(*piece) : MapParts{});
  planTrouble_.clear();
  try {
    map.floorPlan = drawFloorPlan(map, options_.floor_plan);
  } catch (const core::InputError& error) {  // all else of the map is none the worse
    planTrouble_ = error.what();
  }
  return map;
}

FloorSeen MapBuilder::Impl::floorSeen() const {
  FloorSeen floor = floorSeenBy(keyframes_, pieces_.map());
  floor.planTrouble = planTrouble_;
  return floor;
}

SemanticMap MapBuilder::Impl::map(const MapParts& parts) {
  SemanticMap map;
  map.labels = setting_.labels;
  map.zones = setting_.zones.all();
  map.nextObjectId = nextId_;
  map.piece = pieces_.map().value_or(0);
  for (const KeyframeId id : parts.keyframes) {
    const auto entry = keyframes_.find(id);
    if (entry == keyframes_.end()) continue;
    const PlacedKeyframe& keyframe = entry->second;
    const std::string zone = zoneAt(keyframe.piece, keyframe.T_map_cam.translation());
    map.keyframes[id] = {keyframe.stamp_s, keyframe.T_map_cam,     zone,
                         keyframe.piece,   keyframe.freeFan_cam_m, keyframe.ground};
  }
  for (const KeyframeId id : parts.tiles) {
    const auto keyframe = keyframes_.find(id);
    if (keyframe == keyframes_.end()) continue;
    const Part& part = this->part(keyframe->second.piece);
    const Tile* tile = part.cloud.find(id);
    if (tile == nullptr) continue;
    auto shown = shownOf(*tile, part, options_.cloud);
    if (!shown.points.empty()) map.cloud[id] = std::move(shown);
  }
  for (const ObjectId id : parts.objects) {
    for (const auto& [piece, part] : parts_) {
      const auto row = part.table.rows().find(id);
      if (row == part.table.rows().end()) continue;
      MapObject& object = map.objects.insert(*row).first->second;
      object.piece = piece;
      object.zone = zoneAt(piece, object.centroid_m);
    }
  }
  return map;
}

MapMemory MapBuilder::Impl::memory(const std::set<KeyframeId>& tiles) const {
  MapMemory memory;
  for (const auto& [piece, part] : parts_) {
    for (const KeyframeId id : tiles) {
      const Tile* tile = part.cloud.find(id);
      if (tile != nullptr && !tile->points.empty()) memory.tiles[id] = SemanticCloud::remember(*tile);
    }
    for (const auto& [id, record] : part.objects.objects())
      memory.objects.emplace(id, record).first->second.piece = piece;
    memory.pairs.insert(part.objects.pairs().begin(), part.objects.pairs().end());
  }
  return memory;
}

MapParts MapBuilder::Impl::takeChanges() {
  refresh();
  tellOfAnotherMap();
  for (auto& [piece, part] : parts_) changes_.tiles.merge(part.cloud.takeChanges());
  return std::exchange(changes_, {});
}

/// Zones are of the map: where another piece is it now, those of both are told anew.
void MapBuilder::Impl::tellOfAnotherMap() {
  const auto before = std::exchange(toldAsMap_, pieces_.map());
  if (!before || before == toldAsMap_) return;
  for (const auto piece : {*before, *toldAsMap_}) {
    MapParts parts = everything(piece);
    changes_.keyframes.merge(parts.keyframes);
    changes_.objects.merge(parts.objects);
  }
}

std::string MapBuilder::Impl::zoneAt(std::uint32_t piece, const Eigen::Vector3d& p_map_m) const {
  return pieces_.map() == piece ? setting_.zones.at(p_map_m.head<2>()) : std::string();
}

MapBuilder::MapBuilder(const MappingOptions& options, MapSetting setting)
    : impl_(std::make_unique<Impl>(options, std::move(setting))) {}
MapBuilder::~MapBuilder() = default;
MapBuilder::MapBuilder(MapBuilder&&) noexcept = default;
MapBuilder& MapBuilder::operator=(MapBuilder&&) noexcept = default;

void MapBuilder::restore(const SemanticMap& earlier, const MapMemory& memory) { impl_->restore(earlier, memory); }
void MapBuilder::addKeyframe(const odometry::Keyframe& keyframe) { impl_->addKeyframe(keyframe); }
void MapBuilder::apply(const odometry::MapUpdate& update) { impl_->apply(update); }
void MapBuilder::add(const View& view) { impl_->add(view); }
void MapBuilder::compareRuns(const Views& views, const odometry::Pieces& joined, const std::function<void()>& onTile) {
  impl_->compareRuns(views, joined, onTile);
}
SemanticMap MapBuilder::map() { return impl_->map(); }
SemanticMap MapBuilder::map(const MapParts& parts) { return impl_->map(parts); }
FloorSeen MapBuilder::floorSeen() const { return impl_->floorSeen(); }
MapMemory MapBuilder::memory(const std::set<odometry::KeyframeId>& tiles) const { return impl_->memory(tiles); }
MapParts MapBuilder::takeChanges() { return impl_->takeChanges(); }

}  // namespace wardslam::mapping
