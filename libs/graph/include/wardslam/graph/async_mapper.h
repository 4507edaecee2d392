#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>

#include "wardslam/graph/mapper.h"

namespace wardslam::graph {

/// Runs a Mapper in a thread of its own, so that tracking never waits for adjustments. For one calling thread.
class AsyncMapper {
 public:
  explicit AsyncMapper(std::unique_ptr<Mapper> mapper);
  ~AsyncMapper();  ///< Stops what is in work; keyframes that wait are dropped.
  AsyncMapper(const AsyncMapper&) = delete;
  AsyncMapper& operator=(const AsyncMapper&) = delete;

  /// Returns at once. A keyframe that comes during an adjustment over the whole map ends it early.
  void insert(std::shared_ptr<const odometry::Keyframe> keyframe);

  /// What was found out since the last call, oldest first; does not wait. Throws what the mapper threw.
  [[nodiscard]] std::vector<odometry::MapUpdate> takeUpdates();

  /// Waits until all keyframes are worked in, then gives the mapper back. Call only takeUpdates() afterwards.
  [[nodiscard]] std::unique_ptr<Mapper> finish();

 private:
  void work();

  std::unique_ptr<Mapper> mapper_;
  std::atomic<bool> hurry_{false};

  std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  std::deque<std::shared_ptr<const odometry::Keyframe>> waiting_;
  std::vector<odometry::MapUpdate> updates_;
  std::exception_ptr failure_;
  bool stopping_ = false;
  std::thread worker_;
};

}  // namespace wardslam::graph
