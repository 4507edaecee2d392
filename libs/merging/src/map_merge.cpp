#include "wardslam/merging/map_merge.h"

#include <algorithm>
#include <set>
#include <utility>

#include "joined_runs.h"
#include "merged_zones.h"
#include "runs.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"
#include "wardslam/knowledge/knowledge_graph.h"
#include "wardslam/knowledge/motion_rules.h"
#include "wardslam/mapping/map_builder.h"
#include "wardslam/query/map_difference.h"

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

/// What is gone has no points in the cloud to follow.
void moveWhatIsGone(Run& run, const JoinedRuns& joined) {
  for (auto& [id, object] : run.map.semantic.objects) {
    if (object.state != mapping::ObjectState::Gone) continue;
    const Eigen::Vector3d place_m = object.centroid_m;
    const auto away_m = [&](const Eigen::Vector3d& p_m) { return (p_m - place_m).norm(); };
    const Eigen::Isometry3d motion = motionAround(away_m, run, object.piece, joined);
    if (!motion.matrix().isIdentity(0.0)) query::moveObject(object, motion);
  }
}

/// All maps side by side, each piece in a frame of its own but for what has nothing to follow.
pipeline::EarlierMap sideBySide(std::vector<Run>& runs, const JoinedRuns& joined) {
  pipeline::EarlierMap all;
  all.semantic.piece = joined.map;
  for (Run& run : runs) {
    moveWhatIsGone(run, joined);
    all.semantic.keyframes.merge(run.map.semantic.keyframes);
    all.semantic.cloud.merge(run.map.semantic.cloud);
    all.semantic.objects.merge(run.map.semantic.objects);
    all.semantic.nextObjectId = std::max(all.semantic.nextObjectId, run.map.semantic.nextObjectId);
    all.memory.tiles.merge(run.map.memory.tiles);
    all.memory.objects.merge(run.map.memory.objects);
    all.memory.pairs.merge(run.map.memory.pairs);
  }
  return all;
}

/// Everything goes where the graph has it; what stood there later counts; then the pieces become one.
void fuse(mapping::MapBuilder& builder, const JoinedRuns& joined, const ProgressSink& progress) {
  odometry::MapUpdate moved;
  moved.T_map_cam = joined.T_joined_cam;
  builder.apply(moved);
  builder.compareRuns(joined.graph.keyframes, joined.pieces);
  for (std::size_t i = 0; i < joined.joins.size(); ++i) {
    odometry::MapUpdate update;
    update.joined = joined.joins[i];
    builder.apply(update);
    progress({"join", i + 1, joined.joins.size()});
  }
}

storage::GraphContent contentOf(const graph::SavedGraph& graph) {
  storage::GraphContent content;
  for (const auto& keyframe : graph.keyframes) content.sightings[keyframe->id] = keyframe->sightings;
  content.p_map_m = graph.p_map_m;
  return content;
}

mapping::MapParts allOf(const JoinedRuns& joined, mapping::ObjectId nextObjectId) {
  mapping::MapParts parts;
  for (const auto& keyframe : joined.graph.keyframes) parts.keyframes.insert(keyframe->id);
  parts.tiles = parts.keyframes;
  for (mapping::ObjectId id = 1; id < nextObjectId; ++id) parts.objects.insert(id);
  return parts;
}

storage::MapChanges everythingOf(mapping::MapBuilder& builder, const JoinedRuns& joined) {
  const mapping::SemanticMap map = builder.map();
  const mapping::MapParts parts = allOf(joined, map.nextObjectId);
  storage::MapChanges all = storage::everythingOf(builder.map(parts));
  all.floorPlan = map.floorPlan;
  all.mapPiece = map.piece;
  all.views = joined.graph.keyframes;
  all.graph = contentOf(joined.graph);
  for (const graph::Loop& loop : joined.graph.loops)
    all.loops.push_back({loop.older, loop.newer, loop.T_older_newer, loop.inliers});
  all.memory = builder.memory(parts.tiles);
  return all;
}

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
  const JoinedRuns joined = joinRuns(runs, options, progress, &work);
  MergedZones zones = mergeZones(runs, joined);
  storage::MapHeader header{labelsOf(runs), runs.front().header.options, {}};
  MergeReport report{{}, joined.looksBetweenRuns.size(), std::move(zones.notes)};
  for (auto& [piece, part] : partsOf(runs, joined)) {
    header.from[piece] = part.fileList();
    report.parts.push_back(std::move(part));
  }

  mapping::MapBuilder builder(options.mapping, settingOf(header.labels, zones.zones, options));
  const pipeline::EarlierMap all = sideBySide(runs, joined);
  builder.restore(all.semantic, all.memory);
  fuse(builder, joined, progress);
  storage::MapFile::create(out, header, everythingOf(builder, joined)).compact();
  work.remove();
  return report;
}

}  // namespace wardslam::merging
