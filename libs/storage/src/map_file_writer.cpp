#include "wardslam/storage/map_file_writer.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "relative_stamps.h"
#include "wardslam/core/errors.h"

namespace wardslam::storage {
namespace {

/// How long to wait for another program. While the camera moves, tracking may wait for this, and what is new can be
/// written with the next keyframe as well.
constexpr int kPatienceMeanwhile_ms = 200;
constexpr int kPatienceInTheEnd_ms = 2000;

void merge(mapping::MapParts& into, const mapping::MapParts& parts) {
  into.keyframes.insert(parts.keyframes.begin(), parts.keyframes.end());
  into.tiles.insert(parts.tiles.begin(), parts.tiles.end());
  into.objects.insert(parts.objects.begin(), parts.objects.end());
}

/// Everything in `parts`; what the map does not have any more was removed.
MapChanges changesOf(const mapping::SemanticMap& map, const mapping::MapParts& parts) {
  MapChanges changes = everythingOf(map);
  changes.floorPlan.reset();
  for (const auto id : parts.tiles) changes.cloud.try_emplace(id);
  for (const auto id : parts.objects) {
    if (map.objects.count(id) == 0) changes.removedObjects.push_back(id);
  }
  return changes;
}

/// The graph of those keyframes that are in the file.
GraphContent contentOf(const graph::KeyframeGraph& graph, const std::set<odometry::KeyframeId>& keyframes) {
  GraphContent content;
  for (const auto& [id, node] : graph.keyframes()) {
    if (keyframes.count(id) == 0) continue;
    auto& sightings = content.sightings[id];
    for (const auto& [point, keypoint] : node.keypointOf) {
      sightings.push_back({point, keypoint});
      content.p_map_m[point] = graph.points().at(point).point.p_map_m;
    }
  }
  return content;
}

}  // namespace

MapFileWriter::MapFileWriter(const std::filesystem::path& file, const MapHeader& header) {
  if (!std::filesystem::exists(file)) {
    file_ = MapFile::create(file, header);
    return;
  }
  MapFile::requireThatOneCanBeMade(file);
  successor_ = Successor{file, header};
}

MapFileWriter::MapFileWriter(MapFile file) : file_(std::move(file)), goesOn_(true) {
  const auto earlier = file_->read(CloudPart::LeaveOut, PiecePart::All);
  for (const auto& [id, keyframe] : earlier.keyframes) written_.insert(id);
  pending_.mapPiece = earlier.piece;  // goals and zones are in its frame
}

void MapFileWriter::add(const std::shared_ptr<const odometry::Keyframe>& keyframe) {
  pending_.views.push_back(keyframe);
}

void MapFileWriter::apply(const odometry::MapUpdate& update) {
  for (const auto& [point, p_map_m] : update.p_map_m) pending_.p_map_m[point] = p_map_m;
  pending_.fusedPoints.insert(update.fusedPoints.begin(), update.fusedPoints.end());
  pending_.removedPoints.insert(pending_.removedPoints.end(), update.removedPoints.begin(), update.removedPoints.end());
  for (const auto& removed : update.removedKeyframes) {
    auto& views = pending_.views;
    views.erase(std::remove_if(views.begin(), views.end(), [&](const auto& view) { return view->id == removed.id; }),
                views.end());
    pending_.removedKeyframes.push_back(removed.id);
  }
}

MapChanges MapFileWriter::takeFrom(mapping::MapBuilder& builder) {
  merge(unwritten_, builder.takeChanges());
  const mapping::SemanticMap map = builder.map(unwritten_);
  MapChanges changes = changesOf(map, unwritten_);
  changes.mapPiece = pending_.mapPiece;
  changedTiles_.insert(unwritten_.tiles.begin(), unwritten_.tiles.end());
  if (hasBegun_) {
    changes.zones.reset();  // they do not change
  } else if (goesOn_) {
    changes.labels = map.labels;
    changes.outdatesFloorPlan = true;
  }
  changes.p_map_m = pending_.p_map_m;
  changes.fusedPoints = pending_.fusedPoints;
  changes.removedPoints = pending_.removedPoints;
  changes.removedKeyframes = pending_.removedKeyframes;
  for (const auto id : changes.removedKeyframes) changes.cloud.erase(id);  // goes with its keyframe
  std::copy_if(pending_.views.begin(), pending_.views.end(), std::back_inserter(changes.views),
               [&](const auto& view) { return changes.keyframes.count(view->id) > 0 || written_.count(view->id) > 0; });
  if (stampOrigin_s_) makeStampsRelative(changes, *stampOrigin_s_);
  return changes;
}

void MapFileWriter::put(const MapChanges& changes, int patience_ms) {
  if (successor_) {
    if (changes.keyframes.empty()) return;
    file_ = MapFile::create(successor_->file, successor_->header, changes);
    successor_.reset();
  } else {
    file_->write(changes, patience_ms);
  }
  forgetWritten(changes);
}

void MapFileWriter::forgetWritten(const MapChanges& changes) {
  isFailing_ = false;
  hasBegun_ = true;
  for (const auto& [id, keyframe] : changes.keyframes) written_.insert(id);
  for (const auto id : changes.removedKeyframes) written_.erase(id);
  unwritten_ = {};
  auto waiting = std::move(pending_.views);
  waiting.erase(
      std::remove_if(waiting.begin(), waiting.end(), [this](const auto& view) { return written_.count(view->id) > 0; }),
      waiting.end());
  pending_ = {};
  pending_.views = std::move(waiting);
}

void MapFileWriter::fail(const core::InputError& error) {
  ++failedWrites_;
  if (!std::exchange(isFailing_, true)) warn_(std::string(error.what()) + " (what is new is kept and tried again)");
}

void MapFileWriter::write(mapping::MapBuilder& builder) {
  const MapChanges changes = takeFrom(builder);
  try {
    put(changes, kPatienceMeanwhile_ms);
  } catch (const core::InputError& error) {
    fail(error);
  }
}

void MapFileWriter::finish(mapping::MapBuilder& builder, const graph::Mapper& mapper) {
  auto floorPlan = builder.map().floorPlan;  // first: the builder describes all objects anew
  MapChanges changes = takeFrom(builder);
  changes.floorPlan = std::move(floorPlan);
  changes.memory = builder.memory(changedTiles_);
  if (stampOrigin_s_) makeStampsRelative(*changes.memory, *stampOrigin_s_);
  auto keyframes = written_;
  for (const auto& [id, keyframe] : changes.keyframes) keyframes.insert(id);
  for (const auto id : changes.removedKeyframes) keyframes.erase(id);
  changes.graph = contentOf(mapper.graph(), keyframes);
  for (const auto& loop : mapper.loops()) {
    if (keyframes.count(loop.older) > 0 && keyframes.count(loop.newer) > 0) {
      changes.loops.push_back({loop.older, loop.newer, loop.T_older_newer, loop.inliers});
    }
  }
  try {
    put(changes, kPatienceInTheEnd_ms);
  } catch (const MapInUse& error) {
    fail(error);
    file_->writeBeside(changes);
    forgetWritten(changes);
  }
  compact();
}

/// A map that stays larger is none the worse: what was erased in it is overwritten.
void MapFileWriter::compact() {
  if (!file_) return;
  try {
    file_->compact();
  } catch (const core::InputError& error) {
    warn_(std::string(error.what()) + " (the map is complete, but takes more room than it must)");
  }
}

}  // namespace wardslam::storage
