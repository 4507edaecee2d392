#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace wardslam::core {

/// Where a stage does its work.
enum class StageThread {
  Caller,    ///< At once, in the thread that posts: same input, same results.
  Own,       ///< Behind, in a thread like any other.
  GivesWay,  ///< Behind, in a thread that gives way to others (lowerThreadPriority).
};

/// What happens to a task when too much waits.
enum class Necessity {
  Required,  ///< It is done; whoever posts it waits for room.
  Optional,  ///< It may be left out, the oldest first.
};

/// How many tasks there may be.
struct StageCapacity {
  std::size_t required = 64;  ///< That are not done, the one in work among them; at least 1.
  std::size_t optional = 12;  ///< That wait; 0: these are always left out.
};

/// The part of a Stage that does not depend on its worker; what its functions do is said there. For one calling
/// thread.
class StageQueue {
 public:
  /// Throws std::invalid_argument when no required task could ever wait.
  StageQueue(StageThread thread, const StageCapacity& capacity);
  ~StageQueue();
  StageQueue(const StageQueue&) = delete;
  StageQueue& operator=(const StageQueue&) = delete;

  void post(std::function<void()> task, Necessity necessity);
  void rethrowFailure() const;
  void finish();
  void stop();
  [[nodiscard]] std::size_t leftOut() const;
  [[nodiscard]] std::size_t waiting() const;
  [[nodiscard]] const std::atomic<bool>& isWaitedFor() const { return isWaitedFor_; }

 private:
  struct Waiting {
    std::function<void()> task;
    Necessity necessity;
  };

  void enqueue(Waiting waiting);
  void leaveOneOut();
  void run(StageThread thread);
  [[nodiscard]] std::optional<Waiting> takeNext();
  void noteDone();

  StageCapacity capacity_;
  bool isFinished_ = false;  ///< Of the calling thread alone.
  std::atomic<bool> isWaitedFor_{false};

  mutable std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  std::deque<Waiting> waiting_;
  std::size_t requiredUndone_ = 0;
  std::size_t optionalWaiting_ = 0;
  std::size_t leftOut_ = 0;
  std::exception_ptr failure_;
  bool stopping_ = false;
  std::thread thread_;  ///< None where the calling thread works.
};

}  // namespace wardslam::core
