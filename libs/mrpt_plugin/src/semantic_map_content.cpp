#include "semantic_map_content.h"

#include <set>
#include <utility>

#include "wardslam/core/data_files.h"
#include "wardslam/knowledge/motion_rules.h"
#include "wardslam/mapping/cloud_in_map.h"
#include "wardslam/mapping/view_spacing.h"

namespace wardslam::mrpt_plugin {
namespace {

mapping::MappingOptions mappingOptions(const SemanticInsertionOptions& options) {
  return {true, options.views, options.cloud, options.objects, options.floor_plan};
}

mapping::MapSetting settingOf(const SemanticInsertionOptions& options, const core::LabelSpace& labels,
                              const std::vector<mapping::Zone>& zones) {
  const auto knowledge = knowledge::KnowledgeGraph::fromFile(core::findDataFile(options.knowledge));
  const knowledge::MotionRules rules(knowledge, labels);
  return {labels, rules.moving(), mapping::Zones(zones), rules.movable()};
}

std::map<core::ClassId, std::string> namesNewTo(const core::LabelSpace& labels,
                                                const std::map<core::ClassId, std::string>& names) {
  std::map<core::ClassId, std::string> newNames;
  for (const auto& [id, name] : names) {
    if (labels.name(id) != name) newNames.emplace(id, name);
  }
  return newNames;
}

mapping::View viewOf(const core::Frame& frame, odometry::KeyframeId keyframe) {
  mapping::View view;
  view.keyframe = keyframe;
  view.isKeyframe = true;
  view.stamp_s = frame.stamp_s;
  view.camera = frame.camera;
  view.color_bgr = frame.color_bgr;
  view.depth_m = frame.depth_m;
  view.segmentation = frame.segmentation;
  view.mayMove = frame.mayMove;
  return view;
}

std::set<odometry::KeyframeId> keyframesOf(const mapping::SemanticMap& map) {
  std::set<odometry::KeyframeId> ids;
  for (const auto& [id, keyframe] : map.keyframes) ids.insert(id);
  return ids;
}

}  // namespace

std::unique_ptr<SemanticMapContent> SemanticMapContent::clone() {
  refresh();
  auto copy = std::make_unique<SemanticMapContent>(told_);
  copy->memory_ = builder_ ? builder_->memory(keyframesOf(told_)) : memory_;
  copy->last_ = last_;
  copy->options_ = options_;
  return copy;
}

SemanticMapContent::Insertion SemanticMapContent::insert(const SemanticInsertionOptions& options,
                                                         const mrpt::obs::CObservation3DRangeScan& scan,
                                                         const Eigen::Isometry3d& T_map_base) {
  options_ = options;
  Insertion insertion{true, false};
  for (const PlacedFrame& placed : pairing_.put(scan, T_map_base)) {
    if (workIn(placed)) insertion.sawUnannotated |= !placed.isAnnotated;
  }
  isTold_ = false;
  return insertion;
}

SemanticMapContent::Insertion SemanticMapContent::insert(const SemanticInsertionOptions& options,
                                                         const CObservationSemanticRGBD& semantic) {
  options_ = options;
  const auto placed = pairing_.put(semantic);
  return {placed && workIn(*placed), false};
}

/// Whether it showed something new.
bool SemanticMapContent::workIn(const PlacedFrame& placed) {
  const core::StampedPose now{placed.frame.stamp_s, placed.T_map_base * placed.frame.T_base_cam};
  if (last_ && !mapping::isFarEnough(options_.views, *last_, now)) return false;
  const auto newNames = namesNewTo(told_.labels, placed.classes);
  if (!builder_ || !newNames.empty()) openBuilder(newNames);
  odometry::Keyframe keyframe;
  keyframe.id = newest_.id + 1;
  keyframe.submap = told_.piece;
  keyframe.stamp_s = now.stamp_s;
  keyframe.T_map_cam = now.T_map_cam;
  keyframe.T_previous_cam = newest_.T_map_cam.inverse() * now.T_map_cam;
  builder_->addKeyframe(keyframe);
  builder_->add(viewOf(placed.frame, keyframe.id));
  newest_ = keyframe;
  last_ = now;
  isTold_ = false;
  return true;
}

/// What a class can do goes by its name, which a builder learns when it is made: with new names comes a new one, that
/// remembers all the old one knew.
void SemanticMapContent::openBuilder(const std::map<core::ClassId, std::string>& newNames) {
  if (builder_) {
    told_ = builder_->map();
    memory_ = builder_->memory(keyframesOf(told_));
  }
  if (!builder_ && told_.keyframes.empty() && !options_.classes.empty()) {
    told_.labels = core::LabelSpace::cocoWith(core::findDataFile(options_.classes));
  }
  for (const auto& [id, name] : newNames) told_.labels.rename(id, name);
  mapping::MapBuilder builder(mappingOptions(options_), settingOf(options_, told_.labels, told_.zones));
  if (!told_.keyframes.empty()) {
    builder.restore(told_, memory_);
    const auto& [id, keyframe] = *told_.keyframes.rbegin();
    newest_.id = id;
    newest_.T_map_cam = keyframe.T_map_cam;
  }
  memory_ = {};
  builder_ = std::move(builder);
}

void SemanticMapContent::refresh() {
  if (isTold_) return;
  if (const auto pending = pairing_.flush()) static_cast<void>(workIn(*pending));
  if (builder_) told_ = builder_->map();
  views_.reset();
  isTold_ = true;
}

bool SemanticMapContent::isEmpty() {
  const std::lock_guard lock(asking_);
  return isTold_ && told_.keyframes.empty() && told_.cloud.empty() && told_.objects.empty();
}

const mapping::SemanticMap& SemanticMapContent::map() {
  const std::lock_guard lock(asking_);
  refresh();
  return told_;
}

const SemanticMapContent::Views& SemanticMapContent::views() {
  const std::lock_guard lock(asking_);
  refresh();
  if (!views_) {
    auto views = std::make_unique<Views>(Views{{}, {}, query::MapQuery(told_)});
    mapping::forEachCloudPoint(told_, [&views](const Eigen::Vector3f& p_m, const mapping::SemanticPoint& point) {
      views->points.insertPointFast(p_m.x(), p_m.y(), p_m.z());
      views->classOfPoints.push_back(point.classId);
    });
    views->points.mark_as_modified();
    views_ = std::move(views);
  }
  return *views_;
}

std::shared_ptr<const std::vector<ScanSample>> SemanticMapContent::samplesOf(const mrpt::obs::CObservation& observation,
                                                                             const SemanticLikelihoodOptions& options) {
  const std::lock_guard lock(asking_);
  if (sampled_.observation != &observation || sampled_.stamp != observation.timestamp) {
    sampled_ = {&observation, observation.timestamp,
                std::make_shared<const std::vector<ScanSample>>(sampleObservation(observation, options))};
  }
  return sampled_.samples;
}

const mrpt::maps::CSimplePointsMap& SemanticMapContent::points() { return views().points; }
const std::vector<core::ClassId>& SemanticMapContent::classOfPoints() { return views().classOfPoints; }
const query::MapQuery& SemanticMapContent::query() { return views().query; }

}  // namespace wardslam::mrpt_plugin
