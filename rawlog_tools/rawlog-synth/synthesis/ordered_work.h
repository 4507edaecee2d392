#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace wardslam::synth {

/// Items 0 … total-1, made by several threads and taken by the calling one in their order. The threads run ahead by a
/// bounded number of items, so that memory does not grow.
template <class Item>
class OrderedWork {
 public:
  using Maker = std::function<Item(std::size_t index)>;

  /// `make` is called by several threads at once.
  OrderedWork(std::size_t total, std::size_t threads, Maker make)
      : total_(total), ahead_(2 * threads), make_(std::move(make)) {
    for (std::size_t i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
  }
  /// What is not taken yet is dropped.
  ~OrderedWork() {
    stop();
    for (std::thread& thread : threads_) thread.join();
  }
  OrderedWork(const OrderedWork&) = delete;
  OrderedWork& operator=(const OrderedWork&) = delete;

  /// The next item; there must be one. Throws what its maker threw.
  Item take() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return ready_.count(taken_) > 0 || failure_; });
    if (ready_.count(taken_) == 0) std::rethrow_exception(failure_);
    Item item = std::move(ready_.extract(taken_).mapped());
    ++taken_;
    changed_.notify_all();
    return item;
  }

 private:
  void work() {
    try {
      while (const auto index = claim()) {
        Item item = make_(*index);
        const std::lock_guard lock(mutex_);
        ready_.emplace(*index, std::move(item));
        changed_.notify_all();
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      changed_.notify_all();
    }
  }

  std::optional<std::size_t> claim() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return isStopped_ || failure_ || next_ >= total_ || next_ < taken_ + ahead_; });
    if (isStopped_ || failure_ || next_ >= total_) return std::nullopt;
    return next_++;
  }

  void stop() {
    const std::lock_guard lock(mutex_);
    isStopped_ = true;
    changed_.notify_all();
  }

  std::size_t total_;
  std::size_t ahead_;
  Maker make_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::size_t, Item> ready_;
  std::size_t next_ = 0;   ///< To be made.
  std::size_t taken_ = 0;  ///< By the caller.
  std::exception_ptr failure_;
  bool isStopped_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace wardslam::synth
