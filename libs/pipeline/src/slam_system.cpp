#include "wardslam/pipeline/slam_system.h"

#include <algorithm>
#include <string>
#include <utility>

#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"
#include "wardslam/knowledge/motion_rules.h"
#include "wardslam/segmentation/async_segmenter.h"

namespace wardslam::pipeline {
namespace {

std::shared_ptr<const knowledge::KnowledgeGraph> readKnowledge(const SlamOptions& options) {
  const auto file = core::findDataFile(options.knowledge.file, options.file);
  return std::make_shared<knowledge::KnowledgeGraph>(knowledge::KnowledgeGraph::fromFile(file));
}

/// Refines the contours of what moves by itself: its key points must go, those beside it should stay.
std::shared_ptr<segmentation::AsyncSegmenter> makeAsyncSegmenter(const segmentation::SegmentationOptions& options,
                                                                 const knowledge::KnowledgeGraph& knowledge) {
  auto segmenter = segmentation::makeSegmenter(options);
  if (!segmenter) return nullptr;
  const knowledge::MotionRules rules(knowledge, segmenter->labelSpace());
  return std::make_shared<segmentation::AsyncSegmenter>(std::move(segmenter),
                                                        segmentation::makeContourRefiner(options, rules.moving()));
}

knowledge::ClassSet moversIn(const knowledge::KnowledgeGraph& knowledge, const core::LabelSpace& labels) {
  return knowledge::MotionRules(knowledge, labels).moving();
}

std::unique_ptr<graph::Mapper> makeMapper(const SlamOptions& options, const graph::SavedGraph& earlier) {
  auto mapper = std::make_unique<graph::Mapper>(options.graph, options.odometry);
  mapper->restore(earlier);
  return mapper;
}

odometry::Continuation continuationOf(const graph::SavedGraph& earlier) {
  if (earlier.keyframes.empty()) return {};
  odometry::Continuation continuation;
  continuation.lastKeyframe = earlier.keyframes.back()->id;
  for (const auto& keyframe : earlier.keyframes) {
    for (const auto& sighting : keyframe->sightings) {
      continuation.lastPoint = std::max(continuation.lastPoint, sighting.point);
    }
  }
  continuation.submap = 1;
  return continuation;
}

/// A class id means one thing, in the map and in the masks to come.
void requireSameNames(const core::LabelSpace& labels, const mapping::SemanticMap& earlier) {
  for (const auto& [id, object] : earlier.objects) {
    const std::string& before = earlier.labels.name(object.classId);
    const std::string& now = labels.name(object.classId);
    if (before.empty() || now.empty() || before == now) continue;
    throw core::InputError("class " + std::to_string(object.classId) + " is '" + before + "' in the map but '" + now +
                           "' in the masks; use the class names the map was made with");
  }
}

std::unique_ptr<SceneKeeper> makeScene(const SlamOptions& options, mapping::MapSetting setting,
                                       const mapping::SemanticMap& earlier, core::Profiler& profiler) {
  const bool isSegmented = options.segmentation.type != segmentation::SegmentationOptions::Type::None;
  auto builder = std::make_unique<mapping::MapBuilder>(options.mapping, std::move(setting));
  if (!earlier.keyframes.empty()) builder->restore(earlier);
  return std::make_unique<SceneKeeper>(
      std::move(builder), SceneKeeper::Options{options.mapping.views, !options.deterministic, isSegmented}, profiler);
}

mapping::Zones zonesOf(const SlamOptions& options, const mapping::SemanticMap& earlier) {
  if (options.zones.file.empty()) return mapping::Zones(earlier.zones);
  return mapping::Zones::fromFile(core::findDataFile(options.zones.file, options.file));
}

}  // namespace

SlamSystem::SlamSystem(const SlamOptions& options, const EarlierMap& earlier)
    : options_(options),
      knowledge_(readKnowledge(options)),
      segmenter_(makeAsyncSegmenter(options.segmentation, *knowledge_)),
      labels_(segmenter_ ? segmenter_->labelSpace() : core::LabelSpace::coco()),
      zones_(zonesOf(options, earlier.semantic)),
      features_(options.features),
      filters_(options.filters, {segmenter_, knowledge_, options.deterministic}),
      odometry_(options.odometry, continuationOf(earlier.graph)),
      map_(makeMapper(options, earlier.graph), !options.deterministic) {
  hasEarlierMap_ = !earlier.graph.keyframes.empty();
  requireValid(options.map_frame);
  requireSameNames(labels_, earlier.semantic);
  addObserver(trajectory_);
  if (options.mapping.enabled) {
    scene_ = makeScene(options, {labels_, moversIn(*knowledge_, labels_), zones_}, earlier.semantic, profiler_);
  }
}

odometry::OdometryResult SlamSystem::process(const std::shared_ptr<mrpt::obs::CObservation3DRangeScan>& observation) {
  const auto timing = profiler_.measure("pipeline.process");
  core::Frame frame = profiler_.time("sources.build_frame", [&] { return frameBuilder_.build(observation); });
  filters_.begin(frame);                                                  // segmentation starts in its own thread,
  profiler_.time("features.extract", [&] { features_.extract(frame); });  // key points are found meanwhile,
  profiler_.time("filters.apply", [&] { filters_.apply(frame); });        // and what moves is marked
  if (!odometry_.hasStarted()) odometry_.startFrom(startPose(options_.map_frame, frame));
  const auto odometry = profiler_.time("odometry.track", [&] {
    return odometry_.track(frame.stamp_s, frame.camera, core::selectStatic(frame.features));
  });
  filters_.end(frame, odometry.pose());
  if (odometry.keyframe) profiler_.time("graph.insert", [&] { map_.insert(odometry.keyframe); });
  const auto updates = map_.takeUpdates();
  for (const auto& update : updates) {
    odometry_.apply(update);
    if (hasEarlierMap_ && !recognisedAt_s_ && update.joined && update.joined->into == 0)
      recognisedAt_s_ = frame.stamp_s;
  }
  if (scene_) scene_->update(frame, odometry, updates);
  for (FrameObserver* observer : observers_) observer->onFrame(frame, odometry);
  return odometry;
}

void SlamSystem::finish() {
  finishedMap_ = &map_.finish();
  if (!scene_) return;
  for (const auto& update : map_.takeUpdates()) scene_->apply(update);
  scene_->finish();
}

mapping::SemanticMap SlamSystem::semanticMap() const {
  return scene_ ? scene_->finish().map() : mapping::SemanticMap{};
}

void SlamSystem::requireSoundSetup() {
  if (segmenter_) segmenter_->finish();
}

core::Trajectory SlamSystem::trajectory() const {
  std::map<odometry::KeyframeId, Eigen::Isometry3d> T_map_keyframe;
  for (const auto& [id, node] : finishedMap_->graph().keyframes()) T_map_keyframe.emplace(id, node.T_map_cam);
  return trajectory_.corrected(T_map_keyframe);
}

std::string SlamSystem::configuration() const { return writeSlamOptions(options_, filters_); }

}  // namespace wardslam::pipeline
