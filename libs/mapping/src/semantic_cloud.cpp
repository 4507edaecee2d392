#include "semantic_cloud.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "usable_pixels.h"
#include "wardslam/core/depth_noise.h"

namespace wardslam::mapping {
namespace {

constexpr std::int8_t kNewEvidence = 1;
constexpr std::int8_t kLeastEvidence = -1;  // below, the point is gone: it was seen through, and more than once

constexpr float kNoiseReach = 2.0F;  // two sightings of one point differ by no more standard deviations

}  // namespace

void SemanticCloud::addTile(KeyframeId keyframe, const Eigen::Isometry3d& T_map_cam) {
  if (tileOf_.count(keyframe) != 0) return;
  if (!tileOf_.empty()) tiles_[tileOf_.rbegin()->second].points.shrink_to_fit();  // few will come to it now
  if (freeTiles_.empty()) {
    freeTiles_.push_back(static_cast<std::uint32_t>(tiles_.size()));
    tiles_.emplace_back();
  }
  const Eigen::Isometry3f T = T_map_cam.cast<float>();
  tiles_[freeTiles_.back()] = {keyframe, T, T, 0.0F, {}};
  tileOf_[keyframe] = freeTiles_.back();
  freeTiles_.pop_back();
}

std::set<ObjectId> SemanticCloud::movePoses(const std::map<KeyframeId, Eigen::Isometry3d>& T_map_cam) {
  std::vector<std::uint32_t> moved;
  std::set<ObjectId> objects;
  for (const auto& [keyframe, pose] : T_map_cam) {
    const auto entry = tileOf_.find(keyframe);
    if (entry == tileOf_.end()) continue;
    Tile& tile = tiles_[entry->second];
    const Eigen::Isometry3f poseNow = pose.cast<float>();
    if (poseNow.matrix() == tile.T_map_cam.matrix()) continue;
    tile.T_map_cam = poseNow;
    shifted_.insert(keyframe);
    const Eigen::Isometry3f change = tile.T_map_camIndexed.inverse() * tile.T_map_cam;
    const float shift_m = change.translation().norm() + Eigen::AngleAxisf(change.linear()).angle() * tile.radius_m;
    if (shift_m <= static_cast<float>(options_.voxel_m) / 2) continue;
    moved.push_back(entry->second);
    for (const CloudPoint& point : tile.points) {
      if (point.object != 0) objects.insert(point.object);
    }
  }
  reindex(moved);
  return objects;
}

void SemanticCloud::moveTile(KeyframeId from, KeyframeId onto) {
  const std::uint32_t fromIndex = tileOf_.at(from);
  const std::uint32_t ontoIndex = tileOf_.at(onto);
  Tile& tile = tiles_[ontoIndex];
  const Eigen::Isometry3f T_onto_from = tile.T_map_cam.inverse() * tiles_[fromIndex].T_map_cam;
  tile.points.reserve(tile.points.size() + tiles_[fromIndex].points.size());
  for (CloudPoint& point : tiles_[fromIndex].points) {
    point.p_cam_m = T_onto_from * point.p_cam_m;
    index_[point.cell] = {ontoIndex, static_cast<std::uint32_t>(tile.points.size())};
    tile.radius_m = std::max(tile.radius_m, point.p_cam_m.norm());
    tile.points.push_back(point);
    noteVotes(ontoIndex, point.votes);
  }
  changed_.insert({from, onto});
  if (shifted_.erase(from) > 0) shifted_.insert(onto);
  tileOf_.erase(from);
  tiles_[fromIndex] = {};
  freeTiles_.push_back(fromIndex);
}

const Tile* SemanticCloud::find(KeyframeId keyframe) const {
  const auto entry = tileOf_.find(keyframe);
  return entry == tileOf_.end() ? nullptr : &tiles_[entry->second];
}

std::optional<PointRef> SemanticCloud::at(std::uint64_t cell) const {
  const auto entry = index_.find(cell);
  return entry == index_.end() ? std::nullopt : std::optional(entry->second);
}

Eigen::Vector3f SemanticCloud::mapPosition(const PointRef& ref) const {
  return tiles_[ref.tile].T_map_cam * at(ref).p_cam_m;
}

std::vector<std::optional<PointRef>> SemanticCloud::recognise(const std::vector<Sample>& samples,
                                                              const Eigen::Vector3d& camera_map_m) const {
  const auto cell_m = static_cast<float>(options_.voxel_m);
  std::vector<std::optional<PointRef>> points;
  points.reserve(samples.size());
  for (const Sample& sample : samples) {
    const Eigen::Vector3f ray = (sample.p_map_m - camera_map_m.cast<float>()).normalized();
    auto found = at(cellOf(sample.p_map_m, cell_m));
    const float reach_m = kNoiseReach * sample.sigma_m + cell_m / 2;
    for (float d_m = cell_m; !found && d_m < reach_m + cell_m; d_m += cell_m) {
      for (const float along_m : {std::min(d_m, reach_m), -std::min(d_m, reach_m)}) {
        if (!found) found = at(cellOf(sample.p_map_m + along_m * ray, cell_m));
      }
    }
    points.push_back(found);
  }
  return points;
}

void SemanticCloud::fuse(const std::vector<Sample>& samples, const std::vector<std::optional<PointRef>>& points,
                         const std::vector<LabelVote>& votes, KeyframeId keyframe) {
  const std::uint32_t tile = tileOf_.at(keyframe);
  ++fusions_;
  std::vector<PointRef> updated;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (points[i]) {
      update(*points[i], samples[i], votes[i]);
      updated.push_back(*points[i]);
    } else if (const auto made = at(cellOf(samples[i].p_map_m, static_cast<float>(options_.voxel_m)))) {
      update(*made, samples[i], votes[i]);  // another instance's sample in this cell came first
    } else {
      create(tile, samples[i], votes[i]);
    }
  }
  relocate(std::move(updated));
}

void SemanticCloud::update(const PointRef& ref, const Sample& sample, const LabelVote& vote) {
  Tile& tile = tiles_[ref.tile];
  CloudPoint& point = tile.points[ref.point];
  const float weight = 1.0F / (sample.sigma_m * sample.sigma_m);
  const float share = weight / (point.precision_m2 + weight);
  point.p_cam_m += share * (tile.T_map_cam.inverse() * sample.p_map_m - point.p_cam_m);
  point.color_rgb += share * (sample.color_rgb - point.color_rgb);
  point.precision_m2 = std::min(point.precision_m2 + weight, kMostPrecision_m2);
  point.sigma_m = std::min(point.sigma_m, sample.sigma_m);
  point.votes.add(vote.object, vote.weight);
  noteVote(ref.tile, vote.object);
  noteChange(point.object);
  setObject(point, point.votes.winner());
  changed_.insert(tile.keyframe);
  if (point.lastFusion == fusions_) return;  // another sample of the same view
  point.lastFusion = fusions_;
  if (point.sightings < std::numeric_limits<std::uint16_t>::max()) ++point.sightings;
  point.evidence = std::min<std::int8_t>(kMostEvidence, static_cast<std::int8_t>(point.evidence + 1));
}

void SemanticCloud::create(std::uint32_t tileIndex, const Sample& sample, const LabelVote& vote) {
  Tile& tile = tiles_[tileIndex];
  CloudPoint point;
  point.p_cam_m = tile.T_map_cam.inverse() * sample.p_map_m;
  point.color_rgb = sample.color_rgb;
  point.precision_m2 = 1.0F / (sample.sigma_m * sample.sigma_m);
  point.sigma_m = sample.sigma_m;
  point.votes.add(vote.object, vote.weight);
  noteVote(tileIndex, vote.object);
  setObject(point, point.votes.winner());
  point.sightings = 1;
  point.lastFusion = fusions_;
  point.evidence = kNewEvidence;
  point.cell = cellOf(sample.p_map_m, static_cast<float>(options_.voxel_m));
  index_[point.cell] = {tileIndex, static_cast<std::uint32_t>(tile.points.size())};
  tile.radius_m = std::max(tile.radius_m, point.p_cam_m.norm());
  tile.points.push_back(point);
  changed_.insert(tile.keyframe);
}

/// Points whose position changed go to the cell they are in now; where one is already there they become one.
void SemanticCloud::relocate(std::vector<PointRef> moved) {
  std::vector<PointRef> gone;
  for (const PointRef& ref : moved) {
    CloudPoint& mover = point(ref);
    if (mover.sightings == 0) continue;  // was merged into another just now
    const std::uint64_t cell = cellOf(mapPosition(ref), static_cast<float>(options_.voxel_m));
    if (cell == mover.cell) continue;
    index_.erase(mover.cell);
    mover.cell = cell;
    const auto [entry, isFree] = index_.try_emplace(cell, ref);
    if (isFree) continue;
    merge(ref, entry->second);
    gone.push_back(ref);
  }
  erase(std::move(gone));
}

void SemanticCloud::merge(const PointRef& from, const PointRef& into) {
  CloudPoint& gone = point(from);
  CloudPoint& kept = point(into);
  const float share = gone.precision_m2 / (gone.precision_m2 + kept.precision_m2);
  const Eigen::Vector3f p_cam_m = tiles_[into.tile].T_map_cam.inverse() * mapPosition(from);
  kept.p_cam_m += share * (p_cam_m - kept.p_cam_m);
  kept.color_rgb += share * (gone.color_rgb - kept.color_rgb);
  kept.precision_m2 = std::min(kept.precision_m2 + gone.precision_m2, kMostPrecision_m2);
  kept.sigma_m = std::min(kept.sigma_m, gone.sigma_m);
  kept.votes.add(gone.votes);
  noteVotes(into.tile, gone.votes);
  noteChange(kept.object);
  setObject(kept, kept.votes.winner());
  kept.sightings = std::max(kept.sightings, gone.sightings);
  kept.evidence = std::max(kept.evidence, gone.evidence);
  gone.sightings = 0;
  changed_.insert(tiles_[into.tile].keyframe);
}

/// The last point of the tile takes the place of one that goes. The index must not know the ones that go.
void SemanticCloud::erase(std::vector<PointRef> gone) {
  std::sort(gone.begin(), gone.end(), [](const PointRef& a, const PointRef& b) {
    return std::pair(a.tile, a.point) > std::pair(b.tile, b.point);
  });
  for (const PointRef& ref : gone) {
    Tile& tile = tiles_[ref.tile];
    setObject(tile.points[ref.point], 0);
    const bool isLast = ref.point + 1 == tile.points.size();
    if (!isLast) {
      tile.points[ref.point] = tile.points.back();
      index_[tile.points[ref.point].cell] = ref;
    }
    tile.points.pop_back();
    changed_.insert(tile.keyframe);
  }
}

void SemanticCloud::reindex(const std::vector<std::uint32_t>& tiles) {
  for (const std::uint32_t index : tiles) {
    for (const CloudPoint& point : tiles_[index].points) index_.erase(point.cell);
  }
  enter(tiles);
}

void SemanticCloud::enter(const std::vector<std::uint32_t>& tiles) {
  std::vector<PointRef> gone;
  for (const std::uint32_t index : tiles) {
    Tile& tile = tiles_[index];
    tile.T_map_camIndexed = tile.T_map_cam;
    changed_.insert(tile.keyframe);
    for (std::uint32_t i = 0; i < tile.points.size(); ++i) {
      const PointRef ref{index, i};
      tile.points[i].cell = cellOf(mapPosition(ref), static_cast<float>(options_.voxel_m));
      const auto [entry, isFree] = index_.try_emplace(tile.points[i].cell, ref);
      if (isFree) continue;
      merge(ref, entry->second);
      gone.push_back(ref);
    }
  }
  erase(std::move(gone));
}

SemanticCloud::Look SemanticCloud::look(const core::CameraModel& camera, const Eigen::Isometry3d& T_map_cam,
                                        const cv::Mat& depth_m, const cv::Mat& nearest_m) {
  const Eigen::Isometry3f T_cam_map = T_map_cam.inverse().cast<float>();
  Look look;
  std::vector<PointRef> gone;
  for (std::uint32_t t = 0; t < tiles_.size(); ++t) {
    Tile& tile = tiles_[t];
    const Eigen::Isometry3f T_cam_tile = T_cam_map * tile.T_map_cam;
    if (T_cam_tile.translation().norm() > tile.radius_m + static_cast<float>(options_.max_range_m)) continue;
    for (std::uint32_t i = 0; i < tile.points.size(); ++i) {
      CloudPoint& seen = tile.points[i];
      const Eigen::Vector3f p_cam_m = T_cam_tile * seen.p_cam_m;
      if (p_cam_m.z() < 0.1F || p_cam_m.z() > static_cast<float>(options_.max_range_m)) continue;
      const auto raw_px = camera.seenAt(p_cam_m.cast<double>());
      if (!raw_px) continue;
      const auto u = static_cast<int>(std::lround(raw_px->x()));
      const auto v = static_cast<int>(std::lround(raw_px->y()));
      const float behind_m = nearest_m.at<float>(v, u);
      if (behind_m > 0 && behind_m - p_cam_m.z() >
                              edgeStep_m(p_cam_m.z(), camera.depthNoise) + edgeStep_m(behind_m, camera.depthNoise)) {
        if (--seen.evidence >= kLeastEvidence) continue;
        index_.erase(seen.cell);
        gone.push_back({t, i});
        if (seen.object != 0) ++look.erased[seen.object];
      } else if (seen.object != 0) {
        const float measured_m = depth_m.at<float>(v, u);
        const bool isInSight =
            measured_m > 0 && std::abs(measured_m - p_cam_m.z()) < edgeStep_m(p_cam_m.z(), camera.depthNoise);
        if (isInSight) ++look.inSight[seen.object];
      }
    }
  }
  erase(std::move(gone));
  return look;
}

void SemanticCloud::renameObject(ObjectId from, ObjectId into) {
  for (const std::uint32_t t : tilesOf({from})) {
    Tile& tile = tiles_[t];
    for (CloudPoint& point : tile.points) {
      point.votes.rename(from, into);
      if (point.object != from) continue;
      setObject(point, point.votes.winner());
      changed_.insert(tile.keyframe);
    }
  }
  if (from == into) return;
  lastVoted_ = {};
  const auto renamed = tilesOf_.extract(from);
  if (!renamed.empty()) tilesOf_[into].insert(renamed.mapped().begin(), renamed.mapped().end());
}

void SemanticCloud::eraseObject(ObjectId object) {
  std::vector<PointRef> gone;
  for (const std::uint32_t t : tilesOf({object})) {
    for (std::uint32_t i = 0; i < tiles_[t].points.size(); ++i) {
      const CloudPoint& point = tiles_[t].points[i];
      if (point.object != object) continue;
      index_.erase(point.cell);
      gone.push_back({t, i});
    }
  }
  erase(std::move(gone));
}

void SemanticCloud::remove(const std::vector<PointRef>& points) {
  for (const PointRef& ref : points) index_.erase(at(ref).cell);
  erase(points);
}

void SemanticCloud::touchObject(ObjectId object) {
  for (const std::uint32_t t : tilesOf({object})) {
    const Tile& tile = tiles_[t];
    const bool hasIt = std::any_of(tile.points.begin(), tile.points.end(),
                                   [&](const CloudPoint& point) { return point.object == object; });
    if (hasIt) changed_.insert(tile.keyframe);
  }
}

void SemanticCloud::noteVote(std::uint32_t tile, ObjectId object) {
  const std::pair voted(object, tile);
  if (object == 0 || voted == lastVoted_) return;
  tilesOf_[object].insert(tile);
  lastVoted_ = voted;
}

void SemanticCloud::noteVotes(std::uint32_t tile, const ObjectVotes& votes) {
  for (const ObjectVote& vote : votes.votes()) noteVote(tile, vote.object);
}

void SemanticCloud::noteChange(ObjectId object) {
  if (object == 0 || object == lastChanged_) return;
  changedObjects_.insert(object);
  lastChanged_ = object;
}

std::set<ObjectId> SemanticCloud::takeChangedObjects() {
  for (const KeyframeId keyframe : std::exchange(shifted_, {})) {
    const Tile* tile = find(keyframe);
    if (tile == nullptr) continue;
    for (const CloudPoint& point : tile->points) noteChange(point.object);
  }
  lastChanged_ = 0;
  return std::exchange(changedObjects_, {});
}

void SemanticCloud::setObject(CloudPoint& point, ObjectId object) {
  if (point.object == object) return;
  noteChange(point.object);
  noteChange(object);
  if (point.object != 0 && --pointCounts_[point.object] == 0) pointCounts_.erase(point.object);
  if (object != 0) ++pointCounts_[object];
  point.object = object;
}

std::map<ObjectId, std::vector<Eigen::Vector3f>> SemanticCloud::pointsOf(const std::set<ObjectId>& objects) const {
  std::map<ObjectId, std::vector<Eigen::Vector3f>> points;
  for (const ObjectId object : objects) points[object];
  for (const std::uint32_t t : tilesOf(objects)) {
    const Tile& tile = tiles_[t];
    for (const CloudPoint& point : tile.points) {
      if (point.object == 0) continue;
      const auto wanted = points.find(point.object);
      if (wanted != points.end()) wanted->second.push_back(tile.T_map_cam * point.p_cam_m);
    }
  }
  return points;
}

std::set<std::uint32_t> SemanticCloud::tilesOf(const std::set<ObjectId>& objects) const {
  std::set<std::uint32_t> tiles;
  for (const ObjectId object : objects) {
    const auto its = tilesOf_.find(object);
    if (its != tilesOf_.end()) tiles.insert(its->second.begin(), its->second.end());
  }
  return tiles;
}

void SemanticCloud::absorb(SemanticCloud&& other) {
  std::vector<std::uint32_t> added;
  for (const auto& [keyframe, otherIndex] : other.tileOf_) {
    addTile(keyframe, Eigen::Isometry3d::Identity());
    added.push_back(tileOf_.at(keyframe));
    tiles_[added.back()] = std::move(other.tiles_[otherIndex]);
    for (const CloudPoint& point : tiles_[added.back()].points) noteVotes(added.back(), point.votes);
  }
  for (const auto& [object, count] : other.pointCounts_) {
    pointCounts_[object] += count;
    noteChange(object);
  }
  changed_.merge(other.changed_);
  enter(added);
}

}  // namespace wardslam::mapping
