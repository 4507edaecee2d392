#include "wardslam/pipeline/map_keeper.h"

#include <utility>

namespace wardslam::pipeline {

MapKeeper::MapKeeper(std::unique_ptr<graph::Mapper> mapper, bool inBackground) : mapper_(std::move(mapper)) {
  if (inBackground) async_ = std::make_unique<graph::AsyncMapper>(std::move(mapper_));
}

void MapKeeper::insert(const std::shared_ptr<const odometry::Keyframe>& keyframe) {
  if (async_) {
    async_->insert(keyframe);
  } else {
    updates_.push_back(mapper_->insert(keyframe));
  }
}

std::vector<odometry::MapUpdate> MapKeeper::takeUpdates() {
  return async_ ? async_->takeUpdates() : std::exchange(updates_, {});
}

const graph::Mapper& MapKeeper::finish() {
  if (async_) {
    mapper_ = async_->finish();
    updates_ = async_->takeUpdates();
    async_.reset();
  }
  mapper_->adjustAll();
  return *mapper_;
}

}  // namespace wardslam::pipeline
