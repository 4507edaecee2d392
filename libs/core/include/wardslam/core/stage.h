#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

#include "wardslam/core/stage_queue.h"

namespace wardslam::core {

/// Gives a plain, single-threaded class a thread of its own behind the caller, or none: owns the worker and does with
/// it, in order, what is posted. What waits is bounded. For one calling thread.
///
///     core::Stage<graph::Mapper> stage(std::move(mapper), core::StageThread::Own);
///     stage.post([keyframe](graph::Mapper& mapper) { mapper.insert(keyframe); });
///     const auto finished = stage.finish();
///
/// What a task throws in the calling thread comes out of post(), and the stage goes on. What it throws in a thread of
/// its own ends the work; post(), rethrowFailure() and finish() throw it from then on.
template <class Worker>
class Stage {
 public:
  using Task = std::function<void(Worker&)>;

  Stage(std::unique_ptr<Worker> worker, StageThread thread, const StageCapacity& capacity = {})
      : worker_(std::move(worker)), queue_(thread, capacity) {}

  /// A destroyed stage finishes the task in work and drops those that wait.
  ~Stage() = default;
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// Has this done, in turn. Waits only for a required task, and only while the queue is full of such. Throws
  /// std::logic_error after finish().
  void post(Task task, Necessity necessity = Necessity::Required) {
    queue_.post([task = std::move(task), worker = worker_.get()] { task(*worker); }, necessity);
  }

  /// Throws what a task has thrown in the stage's own thread, if one has.
  void rethrowFailure() const { queue_.rethrowFailure(); }

  /// Tasks that were left out because too many waited.
  [[nodiscard]] std::size_t leftOut() const { return queue_.leftOut(); }

  /// Tasks that wait; the one in work is none.
  [[nodiscard]] std::size_t waiting() const { return queue_.waiting(); }

  /// Set while something waits for the task in work to end, or the stage is to be destroyed: a long task may want to
  /// end early then. Lives as long as the stage.
  [[nodiscard]] const std::atomic<bool>& isWaitedFor() const { return queue_.isWaitedFor(); }

  /// Does all that waits, then gives the worker back; null when it was given back before.
  [[nodiscard]] std::unique_ptr<Worker> finish() {
    queue_.finish();
    return std::move(worker_);
  }

  /// Drops all that waits and gives the worker back as it is, also where a task has thrown; null when it was given back
  /// before.
  [[nodiscard]] std::unique_ptr<Worker> giveUp() {
    queue_.stop();
    return std::move(worker_);
  }

 private:
  std::unique_ptr<Worker> worker_;
  StageQueue queue_;  ///< Last: its thread uses the worker.
};

}  // namespace wardslam::core
