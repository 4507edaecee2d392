#include "wardslam/pipeline/scene_keeper.h"

#include <Eigen/Geometry>
#include <utility>

namespace wardslam::pipeline {
namespace {

mapping::View viewOf(const core::Frame& frame, const odometry::OdometryResult& odometry) {
  mapping::View view;
  view.keyframe = odometry.referenceKeyframe;
  view.isKeyframe = odometry.keyframe != nullptr;
  view.T_keyframe_cam = odometry.T_keyframe_cam;
  view.stamp_s = frame.stamp_s;
  view.camera = frame.camera;
  view.color_bgr = frame.color_bgr;
  view.depth_m = frame.depth_m;
  view.segmentation = frame.segmentation;
  view.mayMove = frame.mayMove;
  return view;
}

}  // namespace

SceneKeeper::SceneKeeper(std::unique_ptr<mapping::MapBuilder> builder, const Options& options, core::Profiler& profiler)
    : options_(options), profiler_(profiler), builder_(std::move(builder)) {
  if (options.inBackground) async_ = std::make_unique<mapping::AsyncMapBuilder>(std::move(builder_));
}

void SceneKeeper::update(const core::Frame& frame, const odometry::OdometryResult& odometry,
                         const std::vector<odometry::MapUpdate>& updates) {
  if (odometry.keyframe) add(odometry.keyframe);
  for (const odometry::MapUpdate& found : updates) apply(found);
  if (showsSomethingNew(frame, odometry)) addView(frame, odometry);
  if (odometry.keyframe && writer_ != nullptr) {
    post([this](mapping::MapBuilder& b) { profiler_.time("storage.write", [&] { writer_->write(b); }); });
  }
}

void SceneKeeper::add(const std::shared_ptr<const odometry::Keyframe>& keyframe) {
  post([keyframe, writer = writer_](mapping::MapBuilder& b) {
    b.addKeyframe(*keyframe);
    if (writer != nullptr) writer->add(keyframe);
  });
}

void SceneKeeper::addView(const core::Frame& frame, const odometry::OdometryResult& odometry) {
  lastView_ = {frame.stamp_s, odometry.T_map_cam};
  auto work = [view = viewOf(frame, odometry), &profiler = profiler_](mapping::MapBuilder& b) {
    profiler.time("mapping.add", [&] { b.add(view); });
  };
  async_ ? async_->postView(std::move(work), odometry.keyframe != nullptr) : work(*builder_);
}

bool SceneKeeper::showsSomethingNew(const core::Frame& frame, const odometry::OdometryResult& odometry) const {
  if (!odometry.hasPose()) return false;
  if (options_.needsSegmentation && frame.segmentation.empty()) return false;
  if (odometry.keyframe || !lastView_) return true;
  const Eigen::Isometry3d step = lastView_->T_map_cam.inverse() * odometry.T_map_cam;
  return step.translation().norm() >= options_.views.step_m ||
         Eigen::AngleAxisd(step.linear()).angle() >= options_.views.turn_rad ||
         frame.stamp_s - lastView_->stamp_s >= options_.views.gap_s;
}

void SceneKeeper::apply(const odometry::MapUpdate& update) {
  if (writer_ == nullptr && update.T_map_cam.empty() && update.removedKeyframes.empty() && !update.joined) return;
  post([update, writer = writer_](mapping::MapBuilder& b) {
    b.apply(update);
    if (writer != nullptr) writer->apply(update);
  });
}

void SceneKeeper::post(std::function<void(mapping::MapBuilder&)> work) {
  async_ ? async_->post(std::move(work)) : work(*builder_);
}

mapping::MapBuilder& SceneKeeper::finish() {
  if (async_) {
    dropped_ = async_->dropped();
    builder_ = async_->finish();
    async_.reset();
  }
  return *builder_;
}

}  // namespace wardslam::pipeline
