#include "wardslam/graph/async_mapper.h"

#include <exception>
#include <utility>

#include "wardslam/core/thread_priority.h"

namespace wardslam::graph {

AsyncMapper::AsyncMapper(std::unique_ptr<Mapper> mapper) : mapper_(std::move(mapper)), worker_([this] { work(); }) {}

AsyncMapper::~AsyncMapper() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    waiting_.clear();
    hurry_ = true;
  }
  changed_.notify_all();
  if (worker_.joinable()) worker_.join();
}

void AsyncMapper::insert(std::shared_ptr<const odometry::Keyframe> keyframe) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(keyframe));
    hurry_ = true;
  }
  changed_.notify_all();
}

std::vector<odometry::MapUpdate> AsyncMapper::takeUpdates() {
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
  return std::exchange(updates_, {});
}

std::unique_ptr<Mapper> AsyncMapper::finish() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  worker_.join();
  if (failure_) std::rethrow_exception(failure_);
  return std::move(mapper_);
}

void AsyncMapper::work() {
  core::lowerThreadPriority();
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    const auto keyframe = std::move(waiting_.front());
    waiting_.pop_front();
    hurry_ = !waiting_.empty();
    lock.unlock();
    odometry::MapUpdate update;
    std::exception_ptr failure;
    try {
      update = mapper_->insert(keyframe, &hurry_);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    updates_.push_back(std::move(update));
    if (failure) {
      failure_ = failure;
      return;
    }
  }
}

}  // namespace wardslam::graph
