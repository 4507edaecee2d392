#include "wardslam/pipeline/slam_system.h"

#include "wardslam/core/data_files.h"
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

std::unique_ptr<SceneKeeper> makeScene(const SlamOptions& options, const knowledge::KnowledgeGraph& knowledge,
                                       const core::LabelSpace& labels, const mapping::Zones& zones,
                                       core::Profiler& profiler) {
  mapping::MapSetting setting{labels, knowledge::MotionRules(knowledge, labels).moving(), zones};
  const bool isSegmented = options.segmentation.type != segmentation::SegmentationOptions::Type::None;
  return std::make_unique<SceneKeeper>(std::make_unique<mapping::MapBuilder>(options.mapping, std::move(setting)),
                                       SceneKeeper::Options{options.mapping.views, !options.deterministic, isSegmented},
                                       profiler);
}

mapping::Zones readZones(const SlamOptions& options) {
  if (options.zones.file.empty()) return {};
  return mapping::Zones::fromFile(core::findDataFile(options.zones.file, options.file));
}

}  // namespace

SlamSystem::SlamSystem(const SlamOptions& options)
    : options_(options),
      knowledge_(readKnowledge(options)),
      segmenter_(makeAsyncSegmenter(options.segmentation, *knowledge_)),
      labels_(segmenter_ ? segmenter_->labelSpace() : core::LabelSpace::coco()),
      zones_(readZones(options)),
      features_(options.features),
      filters_(options.filters, {segmenter_, knowledge_, options.deterministic}),
      odometry_(options.odometry),
      map_(std::make_unique<graph::Mapper>(options.graph, options.odometry), !options.deterministic) {
  requireValid(options.map_frame);
  addObserver(trajectory_);
  if (options.mapping.enabled) scene_ = makeScene(options, *knowledge_, labels_, zones_, profiler_);
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
  for (const auto& update : updates) odometry_.apply(update);
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
