#include "wardslam/merging/map_merge.h"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "fused_part.h"
#include "joined_runs.h"
#include "merged_zones.h"
#include "runs.h"
#include "unfinished_map.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"
#include "wardslam/knowledge/knowledge_graph.h"
#include "wardslam/knowledge/motion_rules.h"
#include "wardslam/mapping/map_builder.h"

namespace wardslam::merging {
namespace {

/// Of the newest map, and what others call classes of their things.
core::LabelSpace labelsOf(const std::vector<Run>& runs) {
  core::LabelSpace labels = runs.back().header.labels;
  for (const Run& run : runs) {
    for (const auto& [id, object] : run.map.semantic.objects)
      labels.rename(object.classId, run.header.labels.name(object.classId));
  }
  return labels;
}

mapping::MapSetting settingOf(const core::LabelSpace& labels, const std::vector<mapping::Zone>& zones,
                              const pipeline::SlamOptions& options) {
  const auto file = core::findDataFile(options.knowledge.file, options.file);
  const knowledge::MotionRules rules(knowledge::KnowledgeGraph::fromFile(file), labels);
  return {labels, rules.moving(), mapping::Zones(zones), rules.movable()};
}

/// Keyframe by keyframe: where it is, in which part.
std::map<odometry::KeyframeId, mapping::MappedKeyframe> placedKeyframes(const std::vector<Run>& runs,
                                                                        const JoinedRuns& joined) {
  std::map<odometry::KeyframeId, mapping::MappedKeyframe> keyframes;
  for (const Run& run : runs) {
    for (const auto& [id, known] : run.map.semantic.keyframes) {
      mapping::MappedKeyframe& keyframe = keyframes.emplace(id, known).first->second;
      keyframe.piece = joined.pieces.pieceOf(known.piece);
      keyframe.zone.clear();
      const auto placed = joined.T_joined_cam.find(id);
      if (placed != joined.T_joined_cam.end()) keyframe.T_map_cam = placed->second;
    }
  }
  return keyframes;
}

/// All but what hangs on keyframes.
storage::MapChanges graphOf(const std::vector<Run>& runs, const JoinedRuns& joined) {
  storage::MapChanges changes;
  changes.keyframes = placedKeyframes(runs, joined);
  changes.mapPiece = joined.map;
  changes.views = joined.graph.keyframes;
  changes.graph.emplace();
  for (const auto& keyframe : joined.graph.keyframes) changes.graph->sightings[keyframe->id] = keyframe->sightings;
  changes.graph->p_map_m = joined.graph.p_map_m;
  for (const graph::Loop& loop : joined.graph.loops)
    changes.loops.push_back({loop.older, loop.newer, loop.T_older_newer, loop.inliers});
  for (const Run& run : runs) changes.nextObjectId = std::max(changes.nextObjectId, run.map.semantic.nextObjectId);
  return changes;
}

/// What tells what was there, without what recognises it.
mapping::MapBuilder::Views depthsOf(const graph::SavedGraph& graph) {
  mapping::MapBuilder::Views views;
  for (const auto& keyframe : graph.keyframes) {
    auto view = std::make_shared<odometry::Keyframe>();
    view->id = keyframe->id;
    view->stamp_s = keyframe->stamp_s;
    view->camera = keyframe->camera;
    view->depth = keyframe->depth;
    views.push_back(std::move(view));
  }
  return views;
}

/// Counts tiles: each is compared with what others saw, and written.
class TileCount {
 public:
  TileCount(std::size_t keyframes, const ProgressSink& progress) : total_(2 * keyframes), progress_(progress) {}

  void operator()() { progress_({"tile", ++done_, total_}); }

 private:
  std::size_t done_ = 0;
  std::size_t total_;
  const ProgressSink& progress_;
};

/// Everything that hangs on keyframes, part by part, so that no more than one part and one map are in memory.
class PartWriter {
 public:
  PartWriter(const std::vector<Run>& runs, const JoinedRuns& joined, mapping::MapBuilder::Views views,
             UnfinishedMap& file, const ProgressSink& progress)
      : runs_(runs), joined_(joined), views_(std::move(views)), file_(file), tileDone_(views_.size(), progress) {}

  void write(std::uint32_t piece, mapping::MapBuilder builder) {
    FusedPart part(piece, runs_, joined_, views_, std::move(builder), std::ref(tileDone_));
    const mapping::SemanticMap map = part.builder().map();
    storage::MapChanges changes = storage::everythingOf(part.builder().map(whatIsIn(part, map)));
    changes.floorPlan = map.floorPlan;
    if (piece != joined_.map) {
      changes.floorPlan.reset();
      changes.zones.reset();
    }
    file_.write(changes);
    writeTiles(part);
  }

  /// When all parts are written: it is of them all.
  void writeMemory() {
    storage::MapChanges changes;
    changes.memory = std::move(memory_);
    file_.write(changes);
  }

 private:
  static constexpr std::size_t kTogether = 32;  // tiles

  static mapping::MapParts whatIsIn(const FusedPart& part, const mapping::SemanticMap& map) {
    mapping::MapParts all;
    all.keyframes = part.keyframes();
    for (mapping::ObjectId id = 1; id < map.nextObjectId; ++id) all.objects.insert(id);
    return all;
  }

  void writeTiles(FusedPart& part) {
    mapping::MapParts some;
    for (const odometry::KeyframeId id : part.keyframes()) {
      some.tiles.insert(id);
      if (some.tiles.size() == kTogether || id == *part.keyframes().rbegin()) writeTiles(part.builder(), some);
      tileDone_();
    }
  }

  void writeTiles(mapping::MapBuilder& builder, mapping::MapParts& some) {
    storage::MapChanges changes;
    changes.cloud = builder.map(some).cloud;
    mapping::MapMemory memory = builder.memory(some.tiles);
    changes.memory.emplace();
    changes.memory->tiles = std::move(memory.tiles);
    file_.write(changes);
    memory_.objects.merge(memory.objects);
    memory_.pairs.merge(memory.pairs);
    some.tiles.clear();
  }

  const std::vector<Run>& runs_;
  const JoinedRuns& joined_;
  mapping::MapBuilder::Views views_;
  UnfinishedMap& file_;
  TileCount tileDone_;
  mapping::MapMemory memory_;  ///< Of objects.
};

/// By piece; the map first, then what has most keyframes.
std::vector<std::pair<std::uint32_t, MergeReport::Part>> partsOf(const std::vector<Run>& runs,
                                                                 const JoinedRuns& joined) {
  std::vector<std::pair<std::uint32_t, MergeReport::Part>> parts;
  for (const auto& [piece, keyframes] : joined.pieces.sizes()) {
    MergeReport::Part part;
    part.keyframes = keyframes;
    for (const Run& run : runs) {
      const auto& its = run.map.graph.keyframes;
      const bool isOf = std::any_of(its.begin(), its.end(), [&, piece = piece](const auto& keyframe) {
        return joined.pieces.pieceOf(keyframe->submap) == piece;
      });
      if (isOf) part.files.push_back(run.name);
    }
    parts.emplace_back(piece, std::move(part));
  }
  std::stable_sort(parts.begin(), parts.end(), [&](const auto& a, const auto& b) {
    return std::pair(a.first == joined.map, a.second.keyframes) > std::pair(b.first == joined.map, b.second.keyframes);
  });
  return parts;
}

void requireThatNoMapIsReplaced(const std::vector<std::filesystem::path>& maps, const std::filesystem::path& out) {
  for (const auto& map : maps) {
    std::error_code error;
    if (!std::filesystem::equivalent(map, out, error)) continue;
    throw core::InputError(out.string() + ": is one of the maps, which stay as they are; name another file");
  }
}

}  // namespace

std::string MergeReport::Part::fileList() const {
  std::string list;
  for (const std::string& file : files) list += (list.empty() ? "" : ", ") + file;
  return list;
}

MergeReport mergeMaps(const std::vector<std::filesystem::path>& maps, const std::filesystem::path& out,
                      const pipeline::SlamOptions& options, const ProgressSink& progress) {
  requireThatNoMapIsReplaced(maps, out);
  storage::MapFile::requireThatOneCanBeMade(out);
  std::vector<Run> runs = readRuns(maps, progress);
  requireThatTheyFit(runs);
  const WorkFile work(out, runs, options);
  JoinedRuns joined = joinRuns(runs, options, progress, &work);
  const MergedZones zones = mergeZones(runs, joined);
  storage::MapHeader header{labelsOf(runs), runs.front().header.options, {}};
  MergeReport report{{}, joined.looksBetweenRuns.size(), zones.notes};
  for (auto& [piece, part] : partsOf(runs, joined)) {
    header.from[piece] = part.fileList();
    report.parts.push_back(std::move(part));
  }

  UnfinishedMap file(out, header, graphOf(runs, joined));
  PartWriter writer(runs, joined, depthsOf(joined.graph), file, progress);
  joined.graph = {};  // is in the file
  for (Run& run : runs) {
    run.map.graph = {};
    moveWhatIsGone(run, joined);
  }
  for (const auto& [piece, keyframes] : joined.pieces.sizes()) {
    const bool isMap = piece == joined.map;  // zones are in its frame
    const auto setting = settingOf(header.labels, isMap ? zones.zones : std::vector<mapping::Zone>{}, options);
    writer.write(piece, mapping::MapBuilder(options.mapping, setting));
  }
  writer.writeMemory();
  file.finish();
  work.remove();
  return report;
}

}  // namespace wardslam::merging
