#include "wardslam/pipeline/front_end.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include "wardslam/core/annotation.h"
#include "wardslam/core/data_files.h"
#include "wardslam/filters/annotation.h"
#include "wardslam/masks/async_segmenter.h"

namespace wardslam::pipeline {
namespace {

std::shared_ptr<const knowledge::KnowledgeGraph> readKnowledge(const SlamOptions& options) {
  const auto file = core::findDataFile(options.knowledge.file, options.file);
  return std::make_shared<knowledge::KnowledgeGraph>(knowledge::KnowledgeGraph::fromFile(file));
}

/// Refines the contours of what moves by itself: its key points must go, those beside it should stay.
std::shared_ptr<masks::AsyncSegmenter> makeAsyncSegmenter(const SegmentationSection& options,
                                                          const knowledge::KnowledgeGraph& knowledge) {
  auto segmenter = segmentation::makeSegmenter(options);
  if (!segmenter) return nullptr;
  const knowledge::MotionRules rules(knowledge, segmenter->labelSpace());
  const bool isNetwork = options.type != segmentation::SegmentationOptions::Type::RecordedMasks;
  return std::make_shared<masks::AsyncSegmenter>(
      std::move(segmenter), masks::makeContourRefiner(options.refinement, isNetwork, rules.moving()));
}

}  // namespace

FrontEnd::FrontEnd(const SlamOptions& options, const odometry::Continuation& earlier)
    : mapFrame_(options.map_frame),
      annotates_(options.annotate),
      knowledge_(readKnowledge(options)),
      segmenter_(options.segments() ? makeAsyncSegmenter(options.segmentation, *knowledge_) : nullptr),
      labels_(segmenter_ ? segmenter_->labelSpace() : core::LabelSpace::coco()),
      features_(options.features),
      filters_(options.filters, {segmenter_, knowledge_, options.deterministic}),
      odometry_(options.odometry, earlier) {
  requireValid(mapFrame_);
}

FrontEnd::Result FrontEnd::process(const std::shared_ptr<mrpt::obs::CObservation3DRangeScan>& observation,
                                   const std::optional<odometry::MotionPrior>& motion) {
  core::removeAnnotation(*observation);  // of an earlier run
  core::Frame frame = profiler_.time("sources.build_frame", [&] { return frameBuilder_.build(observation); });
  profiler_.time("filters.begin", [&] { filters_.begin(frame); });        // segmentation starts in its own thread,
  profiler_.time("features.extract", [&] { features_.extract(frame); });  // key points are found meanwhile,
  profiler_.time("filters.apply", [&] { filters_.apply(frame); });        // and what moves is marked
  if (annotates_) profiler_.time("filters.annotate", [&] { filters::annotateObservation(frame); });
  if (!odometry_.hasStarted()) odometry_.startFrom(startPose(mapFrame_, frame));
  std::optional<odometry::MotionPrior> ofCamera;
  if (motion) ofCamera = odometry::transformed(*motion, frame.T_base_cam);
  const auto placeAnew = [&](const Eigen::Isometry3d& T_map_cam) {
    return groundWatch_.placeAnew(T_map_cam, frame.camera, frame.depth_m);
  };
  auto odometry = profiler_.time("odometry.track", [&] {
    return odometry_.track(frame.stamp_s, frame.camera, core::selectStatic(frame.features),
                           {frame.depth_m, frame.mayMove}, ofCamera, placeAnew);
  });
  if (odometry.keyframe) {
    odometry.keyframe =
        profiler_.time("mapping.ground", [&] { return groundWatch_.look(odometry.keyframe, frame.depth_m); });
  }
  const auto T_map_cam = odometry.pose();
  const auto T_odom_cam = T_map_cam ? std::optional(T_odom_map_ * *T_map_cam) : std::nullopt;
  profiler_.time("filters.end", [&] { filters_.end(frame, T_odom_cam); });
  return {std::move(frame), std::move(odometry)};
}

void FrontEnd::apply(const std::shared_ptr<const odometry::MapUpdate>& update) {
  const Eigen::Isometry3d correction = odometry_.apply(update);
  T_odom_map_ = T_odom_map_ * correction.inverse();
  groundWatch_.follow(correction);
}

void FrontEnd::requireSoundSetup() {
  if (segmenter_) segmenter_->finish();
}

knowledge::ClassSet FrontEnd::movers() const { return knowledge::MotionRules(*knowledge_, labels_).moving(); }

knowledge::ClassSet FrontEnd::movables() const { return knowledge::MotionRules(*knowledge_, labels_).movable(); }

}  // namespace wardslam::pipeline
