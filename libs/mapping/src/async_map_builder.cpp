#include "wardslam/mapping/async_map_builder.h"

#include <algorithm>
#include <utility>

#include "wardslam/core/thread_priority.h"

namespace wardslam::mapping {

AsyncMapBuilder::AsyncMapBuilder(std::unique_ptr<MapBuilder> builder)
    : builder_(std::move(builder)), worker_([this] { run(); }) {}

AsyncMapBuilder::~AsyncMapBuilder() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    waiting_.clear();
  }
  changed_.notify_all();
  if (worker_.joinable()) worker_.join();
}

void AsyncMapBuilder::post(std::function<void(MapBuilder&)> work) { push({std::move(work), false, false}); }

void AsyncMapBuilder::postView(std::function<void(MapBuilder&)> work, bool isKeyframe) {
  push({std::move(work), true, isKeyframe});
}

std::size_t AsyncMapBuilder::dropped() const {
  const std::lock_guard lock(mutex_);
  return dropped_;
}

std::unique_ptr<MapBuilder> AsyncMapBuilder::finish() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  worker_.join();
  if (failure_) std::rethrow_exception(failure_);
  return std::move(builder_);
}

void AsyncMapBuilder::push(Task task) {
  {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
    if (task.isView) ++viewsWaiting_;
    waiting_.push_back(std::move(task));
    if (viewsWaiting_ > kMaxWaiting) dropOne();
  }
  changed_.notify_all();
}

void AsyncMapBuilder::dropOne() {
  auto dropped =
      std::find_if(waiting_.begin(), waiting_.end(), [](const Task& t) { return t.isView && !t.isKeyframe; });
  if (dropped == waiting_.end()) {
    dropped = std::find_if(waiting_.begin(), waiting_.end(), [](const Task& t) { return t.isView; });
  }
  waiting_.erase(dropped);
  --viewsWaiting_;
  ++dropped_;
}

void AsyncMapBuilder::run() {
  core::lowerThreadPriority();
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    const Task task = std::move(waiting_.front());
    waiting_.pop_front();
    if (task.isView) --viewsWaiting_;
    lock.unlock();
    std::exception_ptr failure;
    try {
      task.work(*builder_);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    if (!failure) continue;
    failure_ = failure;
    return;
  }
}

}  // namespace wardslam::mapping
