#include "wardslam/mapping/map_builder.h"

#include <algorithm>
#include <iterator>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>

#include "detections.h"
#include "object_database.h"
#include "object_table.h"
#include "same_things.h"
#include "semantic_cloud.h"
#include "things_in_hands.h"
#include "usable_pixels.h"
#include "wardslam/core/view_rays.h"

namespace wardslam::mapping {
namespace {

/// A class not seen says less than a class seen: networks miss things more often than they see what is not there.
constexpr float kUnclassifiedWeight = 0.25F;

/// Points are taken for seen through only when everything so near (px) to them is farther away.
constexpr int kSeenThroughMargin_px = 2;

cv::Mat nearestAround(const cv::Mat& depth_m) {
  const int side = 2 * kSeenThroughMargin_px + 1;
  cv::Mat nearest;  // holes stay holes, and spread: what is not measured is not seen through
  cv::erode(depth_m, nearest, cv::getStructuringElement(cv::MORPH_RECT, {side, side}));
  return nearest;
}

/// What submaps have each.
struct Part {
  explicit Part(const MappingOptions& options) : cloud(options.cloud), objects(options.objects) {}
  SemanticCloud cloud;
  ObjectDatabase objects;
};

struct PlacedKeyframe {
  std::uint32_t submap = 0;
  double stamp_s = 0.0;
  Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Vector3f> freeFan_cam_m;
};

}  // namespace

class MapBuilder::Impl {
 public:
  Impl(const MappingOptions& options, MapSetting setting)
      : options_(options), setting_(std::move(setting)), table_(options.objects) {}

  void restore(const SemanticMap& earlier);
  void addKeyframe(const odometry::Keyframe& keyframe);
  void apply(const odometry::MapUpdate& update);
  void add(const View& view);
  SemanticMap map();
  SemanticMap map(const MapParts& parts);
  MapParts takeChanges();

 private:
  Part& part(std::uint32_t submap) { return parts_.try_emplace(submap, options_).first->second; }
  void join(std::uint32_t from, std::uint32_t into);
  void remove(const odometry::RemovedKeyframe& removed);
  [[nodiscard]] Eigen::Isometry3d placeOf(const odometry::Keyframe& keyframe, std::uint32_t submap) const;
  [[nodiscard]] std::map<KeyframeId, Eigen::Isometry3d> withYounger(const odometry::MapUpdate& update) const;
  void follow(const std::map<KeyframeId, Eigen::Isometry3d>& T_map_cam);
  const cv::Mat& raysOf(const core::CameraModel& camera);
  std::vector<ObjectId> recogniseObjects(Part& part, const View& view,
                                         const std::vector<std::optional<PointRef>>& points,
                                         const std::vector<Detection>& detections,
                                         const std::map<ObjectId, std::size_t>& inSight);
  void takeMerges(Part& part);
  void removeGone(Part& part, const std::vector<ObjectId>& gone);
  void refresh();
  void mergeSameBoxes();
  void reuniteMoved();
  void describeTouched();
  [[nodiscard]] SemanticCloudTile publish(const Tile& tile) const;

  MappingOptions options_;
  MapSetting setting_;
  std::map<KeyframeId, PlacedKeyframe> keyframes_;
  std::map<std::uint32_t, std::uint32_t> joinedInto_;
  std::map<std::uint32_t, Part> parts_;
  std::optional<std::uint32_t> first_;  ///< The submap whose part is the map.
  ObjectId nextId_ = 1;
  ObjectTable table_;
  std::set<ObjectId> touched_;
  MapParts changes_;
  std::optional<core::CameraModel> raysCamera_;
  cv::Mat rays_;
};

void MapBuilder::Impl::restore(const SemanticMap& earlier) {
  constexpr std::uint32_t kSubmap = 0;
  first_ = kSubmap;
  Part& main = part(kSubmap);
  for (const auto& [id, keyframe] : earlier.keyframes) {
    keyframes_[id] = {kSubmap, keyframe.stamp_s, keyframe.T_map_cam, keyframe.freeFan_cam_m};
    const auto tile = earlier.cloud.find(id);
    main.cloud.restore(id, keyframe.T_map_cam, tile == earlier.cloud.end() ? SemanticCloudTile{} : tile->second);
  }
  for (const auto& [id, object] : earlier.objects) {
    main.objects.restore(id, ObjectRecord::from(object));
    table_.restore(object);
    nextId_ = std::max(nextId_, id + 1);
  }
  static_cast<void>(main.cloud.takeChanges());  // the earlier run has written them
}

void MapBuilder::Impl::addKeyframe(const odometry::Keyframe& keyframe) {
  const auto joined = joinedInto_.find(keyframe.submap);
  const std::uint32_t submap = joined == joinedInto_.end() ? keyframe.submap : joined->second;
  if (!first_) first_ = submap;
  const Eigen::Isometry3d T_map_cam = placeOf(keyframe, submap);
  keyframes_[keyframe.id] = {submap, keyframe.stamp_s, T_map_cam, {}};
  part(submap).cloud.addTile(keyframe.id, T_map_cam);
  changes_.keyframes.insert(keyframe.id);
}

/// As the keyframe graph places it: by the one before, where the map has that in the same frame.
Eigen::Isometry3d MapBuilder::Impl::placeOf(const odometry::Keyframe& keyframe, std::uint32_t submap) const {
  const auto previous = keyframes_.find(keyframe.id - 1);
  const bool follows = previous != keyframes_.end() && previous->second.submap == submap;
  return follows ? previous->second.T_map_cam * keyframe.T_previous_cam : keyframe.T_map_cam;
}

void MapBuilder::Impl::apply(const odometry::MapUpdate& update) {
  follow(withYounger(update));
  for (const auto& removed : update.removedKeyframes) remove(removed);
  if (update.joined) join(update.joined->from, update.joined->into);
}

/// The poses it names, and those of keyframes that it does not know yet.
std::map<KeyframeId, Eigen::Isometry3d> MapBuilder::Impl::withYounger(const odometry::MapUpdate& update) const {
  auto T_map_cam = update.T_map_cam;
  const auto newest = keyframes_.find(update.newestKeyframe);
  if (newest == keyframes_.end()) return T_map_cam;
  const Eigen::Isometry3d correction = odometry::correctionOf(update, newest->second.T_map_cam);
  for (auto younger = std::next(newest); younger != keyframes_.end(); ++younger) {
    const auto& [id, keyframe] = *younger;
    if (keyframe.submap == newest->second.submap) T_map_cam.try_emplace(id, correction * keyframe.T_map_cam);
  }
  return T_map_cam;
}

void MapBuilder::Impl::follow(const std::map<KeyframeId, Eigen::Isometry3d>& T_map_cam) {
  for (const auto& [id, pose] : T_map_cam) {
    const auto keyframe = keyframes_.find(id);
    if (keyframe == keyframes_.end()) continue;
    keyframe->second.T_map_cam = pose;
    changes_.keyframes.insert(id);
  }
  for (auto& [submap, part] : parts_) {
    touched_.merge(part.cloud.movePoses(T_map_cam));
  }
}

/// The heir saw the same floor free.
void MapBuilder::Impl::remove(const odometry::RemovedKeyframe& removed) {
  const auto keyframe = keyframes_.find(removed.id);
  const auto heir = keyframes_.find(removed.heir);
  if (keyframe == keyframes_.end() || heir == keyframes_.end()) return;
  Part& part = this->part(keyframe->second.submap);
  touched_.merge(part.cloud.movePoses({{removed.id, heir->second.T_map_cam * removed.T_heir_cam}}));
  part.cloud.moveTile(removed.id, removed.heir);
  keyframes_.erase(keyframe);
  changes_.keyframes.insert(removed.id);
}

void MapBuilder::Impl::join(std::uint32_t from, std::uint32_t into) {
  for (auto& [id, keyframe] : keyframes_) {
    if (keyframe.submap != from) continue;
    keyframe.submap = into;
    changes_.keyframes.insert(id);
  }
  for (auto& [submap, joined] : joinedInto_) {
    if (joined == from) joined = into;
  }
  joinedInto_[from] = into;
  const auto joining = parts_.find(from);
  if (joining == parts_.end()) return;
  for (const auto& [id, object] : joining->second.objects.objects()) touched_.insert(id);
  part(into).cloud.absorb(std::move(joining->second.cloud));
  part(into).objects.absorb(std::move(joining->second.objects));
  parts_.erase(joining);
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
  Part& part = this->part(keyframe->second.submap);
  if (view.isKeyframe) {
    keyframe->second.freeFan_cam_m =
        freeFan(view.depth_m, view.camera, keyframe->second.T_map_cam, options_.floor_plan);
  }
  const Eigen::Isometry3d T_map_cam = keyframe->second.T_map_cam * view.T_keyframe_cam;
  const auto cell_m = static_cast<float>(options_.cloud.voxel_m);

  const auto look = part.cloud.look(view.camera, T_map_cam, view.depth_m, nearestAround(view.depth_m));
  removeGone(part, part.objects.erase(look.erased, part.cloud.pointCounts()));
  const cv::Mat usable = usablePixels(view, setting_.moving, options_.cloud);
  const auto samples = sampleView(view, T_map_cam, raysOf(view.camera), usable, cell_m, options_.cloud.pixel_step);
  const auto points = part.cloud.recognise(samples, T_map_cam.translation());
  const auto detections = detect(view.segmentation, samples, setting_.moving, options_.objects, cell_m);
  for (const Handled& thing : thingsInHands(view, setting_.moving)) {
    const Eigen::Vector3f place_m = (T_map_cam * thing.p_cam_m).cast<float>();
    part.objects.noteHandled(thing.classId, place_m, view.stamp_s);
  }
  const auto objects = recogniseObjects(part, view, points, detections, look.inSight);

  std::vector<SemanticCloud::LabelVote> votes(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!view.segmentation.empty() && samples[i].instance == 0) votes[i].weight = kUnclassifiedWeight;
  }
  for (std::size_t d = 0; d < detections.size(); ++d) {
    for (const std::size_t i : detections[d].samples) votes[i] = {objects[d], detections[d].confidence};
  }
  part.cloud.fuse(samples, points, votes, view.keyframe);
  takeMerges(part);
  for (const auto& [id, count] : look.inSight) touched_.insert(id);
  for (const auto& [id, count] : look.erased) touched_.insert(id);
  touched_.insert(objects.begin(), objects.end());
}

std::vector<ObjectId> MapBuilder::Impl::recogniseObjects(Part& part, const View& view,
                                                         const std::vector<std::optional<PointRef>>& points,
                                                         const std::vector<Detection>& detections,
                                                         const std::map<ObjectId, std::size_t>& inSight) {
  const auto objectAt = [&](std::size_t i) { return points[i] ? part.cloud.at(*points[i]).object : 0; };
  std::vector<Evidence> evidence;
  for (const Detection& detection : detections) {
    Evidence& e = evidence.emplace_back();
    e.classId = detection.classId;
    e.confidence = detection.confidence;
    e.size = detection.samples.size();
    e.place_m = detection.centroid_m;
    for (const std::size_t i : detection.samples) {
      if (const ObjectId id = objectAt(i)) ++e.onObjects[id];
    }
    e.underMask = e.onObjects;
    for (const std::size_t i : detection.doubtful) {
      if (const ObjectId id = objectAt(i)) ++e.underMask[id];
    }
  }
  const bool canMiss = !view.segmentation.empty();
  return part.objects.observe(evidence, canMiss ? inSight : std::map<ObjectId, std::size_t>{}, view.stamp_s, nextId_);
}

void MapBuilder::Impl::takeMerges(Part& part) {
  for (const auto& [from, into] : part.objects.takeMerges()) {
    part.cloud.renameObject(from, into);
    touched_.insert({from, into});
  }
}

void MapBuilder::Impl::removeGone(Part& part, const std::vector<ObjectId>& gone) {
  for (const ObjectId id : gone) {
    part.cloud.eraseObject(id);
    touched_.insert(id);
  }
}

void MapBuilder::Impl::refresh() {
  if (!first_) return;
  describeTouched();
  mergeSameBoxes();
  reuniteMoved();
  describeTouched();
}

void MapBuilder::Impl::describeTouched() {
  Part& main = part(*first_);
  takeMerges(main);
  const auto before = table_.rows();
  const auto changed = table_.update(std::exchange(touched_, {}), main.objects, main.cloud);
  for (const ObjectId id : changed) {
    const auto was = before.find(id);
    const auto is = table_.rows().find(id);
    const bool wasThere = was != before.end();
    const bool isThere = is != table_.rows().end();
    if (wasThere != isThere || (isThere && was->second.classId != is->second.classId)) main.cloud.touchObject(id);
  }
  changes_.objects.insert(changed.begin(), changed.end());
}

void MapBuilder::Impl::mergeSameBoxes() {
  Part& main = part(*first_);
  for (const auto& [from, into] : sameBoxes(table_, main.objects, options_.cloud.voxel_m)) {
    main.objects.merge(from, into);
  }
}

void MapBuilder::Impl::reuniteMoved() {
  Part& main = part(*first_);
  for (const auto& [id, object] : table_.rows()) {
    if (object.state == ObjectState::Gone || main.objects.objects().count(id) == 0) continue;  // may just have merged
    const std::vector<ObjectId> lost = earlierPlacesOf(object, table_, main.objects, main.cloud);
    if (lost.empty()) continue;
    removeGone(main, lost);
    touched_.insert(id);
    main.objects.reunite(lost, id);
  }
}

SemanticCloudTile MapBuilder::Impl::publish(const Tile& tile) const {
  const ObjectDatabase& objects = parts_.at(*first_).objects;
  SemanticCloudTile published;
  for (const CloudPoint& point : tile.points) {
    if (point.sightings < options_.cloud.min_sightings) continue;
    if (point.sigma_m > static_cast<float>(options_.cloud.max_sigma_m)) continue;
    SemanticPoint& p = published.points.emplace_back();
    p.p_cam_m = point.p_cam_m;
    for (std::size_t i = 0; i < 3; ++i) {
      p.color_rgb[i] = cv::saturate_cast<std::uint8_t>(point.color_rgb[static_cast<Eigen::Index>(i)]);
    }
    p.sightings = point.sightings;
    const auto record = objects.objects().find(point.object);
    if (record == objects.objects().end()) continue;
    p.classId = record->second.classId();
    if (table_.rows().count(point.object) > 0) p.object = point.object;
  }
  return published;
}

SemanticMap MapBuilder::Impl::map() {
  if (first_) {  // small corrections, too
    for (const auto& [id, count] : part(*first_).cloud.pointCounts()) touched_.insert(id);
  }
  refresh();
  MapParts all;
  for (const auto& [id, keyframe] : keyframes_) {
    all.keyframes.insert(id);
    all.tiles.insert(id);
  }
  for (const auto& [id, object] : table_.rows()) all.objects.insert(id);
  SemanticMap map = this->map(all);
  map.floorPlan = drawFloorPlan(map, options_.floor_plan);
  return map;
}

SemanticMap MapBuilder::Impl::map(const MapParts& parts) {
  SemanticMap map;
  map.labels = setting_.labels;
  map.zones = setting_.zones.all();
  for (const KeyframeId id : parts.keyframes) {
    const auto entry = keyframes_.find(id);
    if (entry == keyframes_.end() || entry->second.submap != first_) continue;
    const PlacedKeyframe& keyframe = entry->second;
    const std::string zone = setting_.zones.at(keyframe.T_map_cam.translation().head<2>());
    map.keyframes[id] = {keyframe.stamp_s, keyframe.T_map_cam, zone, keyframe.freeFan_cam_m};
  }
  for (const KeyframeId id : parts.tiles) {
    const Tile* tile = first_ ? part(*first_).cloud.find(id) : nullptr;
    if (tile == nullptr) continue;
    auto published = publish(*tile);
    if (!published.points.empty()) map.cloud[id] = std::move(published);
  }
  for (const ObjectId id : parts.objects) {
    const auto row = table_.rows().find(id);
    if (row == table_.rows().end()) continue;
    map.objects.insert(*row).first->second.zone = setting_.zones.at(row->second.centroid_m.head<2>());
  }
  return map;
}

MapParts MapBuilder::Impl::takeChanges() {
  refresh();
  if (first_) changes_.tiles = part(*first_).cloud.takeChanges();
  return std::exchange(changes_, {});
}

MapBuilder::MapBuilder(const MappingOptions& options, MapSetting setting)
    : impl_(std::make_unique<Impl>(options, std::move(setting))) {}
MapBuilder::~MapBuilder() = default;
MapBuilder::MapBuilder(MapBuilder&&) noexcept = default;
MapBuilder& MapBuilder::operator=(MapBuilder&&) noexcept = default;

void MapBuilder::restore(const SemanticMap& earlier) { impl_->restore(earlier); }
void MapBuilder::addKeyframe(const odometry::Keyframe& keyframe) { impl_->addKeyframe(keyframe); }
void MapBuilder::apply(const odometry::MapUpdate& update) { impl_->apply(update); }
void MapBuilder::add(const View& view) { impl_->add(view); }
SemanticMap MapBuilder::map() { return impl_->map(); }
SemanticMap MapBuilder::map(const MapParts& parts) { return impl_->map(parts); }
MapParts MapBuilder::takeChanges() { return impl_->takeChanges(); }

}  // namespace wardslam::mapping
