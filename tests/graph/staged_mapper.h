#pragma once

#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include "wardslam/core/mailbox.h"
#include "wardslam/core/stage.h"
#include "wardslam/graph/mapper.h"

namespace wardslam::graph {

/// A mapper as a run has it: in a stage, its findings brought back.
class StagedMapper {
 public:
  explicit StagedMapper(core::StageThread thread, const GraphOptions& options = {})
      : stage_(std::make_unique<Mapper>(options, odometry::OdometryOptions{}), thread) {}

  void insert(const std::shared_ptr<const odometry::Keyframe>& keyframe) {
    stage_.post([this, keyframe](Mapper& mapper) { updates_.put(mapper.insert(keyframe, &stage_.isWaitedFor())); });
  }
  std::vector<odometry::MapUpdate> takeUpdates() {
    stage_.rethrowFailure();
    return updates_.takeAll();
  }
  std::vector<odometry::MapUpdate> waitForUpdates() {
    while (true) {
      auto updates = takeUpdates();
      if (!updates.empty()) return updates;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  std::unique_ptr<Mapper> finish() { return stage_.finish(); }

 private:
  core::Mailbox<odometry::MapUpdate> updates_;
  core::Stage<Mapper> stage_;
};

}  // namespace wardslam::graph
