#include "map_feed.h"

#include <utility>

namespace wardslam::pipeline {

void MapFeed::update(const core::Frame& frame, const odometry::OdometryResult& odometry, const SharedUpdates& updates) {
  if (odometry.keyframe) add(odometry.keyframe);
  for (const auto& found : updates) apply(found);
  if (auto view = selection_.select(frame, odometry)) add(std::move(*view));
  if (odometry.keyframe && writer_ != nullptr) write();
}

void MapFeed::apply(const std::shared_ptr<const odometry::MapUpdate>& update) {
  const bool movesKeyframes = !update->T_map_cam.empty() || !update->removedKeyframes.empty() || update->joined;
  if (writer_ == nullptr && !movesKeyframes) return;
  stage_.post([update, writer = writer_, &profiler = profiler_](mapping::MapBuilder& builder) {
    const auto correction = profiler.measure("mapping.correct");
    builder.apply(*update);
    if (writer != nullptr) writer->apply(*update);
  });
}

void MapFeed::add(const std::shared_ptr<const odometry::Keyframe>& keyframe) {
  stage_.post([keyframe, writer = writer_](mapping::MapBuilder& builder) {
    builder.addKeyframe(*keyframe);
    if (writer != nullptr) writer->add(keyframe);
  });
}

void MapFeed::add(mapping::View view) {
  const bool mayBeLeftOut = whenBehind_ == WhenBehind::LeavesViewsOut && !view.isKeyframe;
  stage_.post([view = std::move(view), &profiler = profiler_](
                  mapping::MapBuilder& builder) { profiler.time("mapping.add", [&] { builder.add(view); }); },
              mayBeLeftOut ? core::Necessity::Optional : core::Necessity::Required);
}

void MapFeed::write() {
  stage_.post([writer = writer_, &profiler = profiler_](mapping::MapBuilder& builder) {
    profiler.time("storage.write", [&] { writer->write(builder); });
  });
}

}  // namespace wardslam::pipeline
