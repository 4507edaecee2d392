#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <string>

namespace wardslam::sources {

/// What waits between a camera and who works on its frames: never more than a few. Whoever is too slow gets the newest
/// ones; the oldest give way. Thread-safe.
class LatestFrames {
 public:
  explicit LatestFrames(std::size_t capacity) : capacity_(capacity) {}

  void push(std::string frame);

  /// The oldest frame that waits; nothing when none comes in time or the queue is closed and empty.
  [[nodiscard]] std::optional<std::string> pop(std::chrono::milliseconds patience);

  void close();                          ///< No more frames will come.
  void discard();                        ///< What waits counts as skipped.
  [[nodiscard]] bool isDrained() const;  ///< Closed, and nothing waits.

  [[nodiscard]] std::size_t pushed() const;
  [[nodiscard]] std::size_t skipped() const;  ///< Gave way to newer ones.

 private:
  std::size_t capacity_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::string> waiting_;
  std::size_t pushed_ = 0;
  std::size_t skipped_ = 0;
  bool isClosed_ = false;
};

}  // namespace wardslam::sources
