#pragma once

#include <mutex>
#include <utility>
#include <vector>

namespace wardslam::core {

/// Brings values from one thread to another; nobody ever waits.
template <class Value>
class Mailbox {
 public:
  void put(Value value) {
    const std::lock_guard lock(mutex_);
    values_.push_back(std::move(value));
  }

  /// What came since the last call, oldest first.
  [[nodiscard]] std::vector<Value> takeAll() {
    const std::lock_guard lock(mutex_);
    return std::exchange(values_, {});
  }

 private:
  std::mutex mutex_;
  std::vector<Value> values_;
};

}  // namespace wardslam::core
