#include "wardslam/core/stage_queue.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "wardslam/core/thread_priority.h"

namespace wardslam::core {

StageQueue::StageQueue(StageThread thread, const StageCapacity& capacity) : capacity_(capacity) {
  if (capacity.required == 0)
    throw std::invalid_argument("a stage without room for required tasks would wait for ever");
  if (thread != StageThread::Caller) thread_ = std::thread([this, thread] { run(thread); });
}

StageQueue::~StageQueue() { stop(); }

void StageQueue::post(std::function<void()> task, Necessity necessity) {
  if (isFinished_) throw std::logic_error("a task was posted to a stage that is finished");
  if (thread_.joinable()) {
    enqueue({std::move(task), necessity});
  } else {
    task();
  }
}

void StageQueue::rethrowFailure() const {
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
}

void StageQueue::finish() {
  isFinished_ = true;
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
  rethrowFailure();
}

void StageQueue::stop() {
  isFinished_ = true;
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    waiting_.clear();
    isWaitedFor_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

std::size_t StageQueue::leftOut() const {
  const std::lock_guard lock(mutex_);
  return leftOut_;
}

std::size_t StageQueue::waiting() const {
  const std::lock_guard lock(mutex_);
  return waiting_.size();
}

void StageQueue::enqueue(Waiting waiting) {
  {
    std::unique_lock lock(mutex_);
    if (waiting.necessity == Necessity::Required) {
      isWaitedFor_ = isWaitedFor_ || requiredUndone_ >= capacity_.required;
      changed_.wait(lock, [this] { return failure_ || requiredUndone_ < capacity_.required; });
    }
    if (failure_) std::rethrow_exception(failure_);
    ++(waiting.necessity == Necessity::Required ? requiredUndone_ : optionalWaiting_);
    waiting_.push_back(std::move(waiting));
    if (optionalWaiting_ > capacity_.optional) leaveOneOut();
    isWaitedFor_ = !waiting_.empty();
  }
  changed_.notify_all();
}

void StageQueue::leaveOneOut() {
  waiting_.erase(std::find_if(waiting_.begin(), waiting_.end(),
                              [](const Waiting& task) { return task.necessity == Necessity::Optional; }));
  --optionalWaiting_;
  ++leftOut_;
}

void StageQueue::run(StageThread thread) {
  if (thread == StageThread::GivesWay) lowerThreadPriority();
  while (const auto next = takeNext()) {
    try {
      next->task();
    } catch (...) {
      {
        const std::lock_guard lock(mutex_);
        failure_ = std::current_exception();
      }
      changed_.notify_all();
      return;
    }
    if (next->necessity == Necessity::Required) noteDone();
  }
}

std::optional<StageQueue::Waiting> StageQueue::takeNext() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
  if (waiting_.empty()) return std::nullopt;
  Waiting next = std::move(waiting_.front());
  waiting_.pop_front();
  if (next.necessity == Necessity::Optional) --optionalWaiting_;
  isWaitedFor_ = !waiting_.empty();
  return next;
}

void StageQueue::noteDone() {
  {
    const std::lock_guard lock(mutex_);
    --requiredUndone_;
  }
  changed_.notify_all();
}

}  // namespace wardslam::core
