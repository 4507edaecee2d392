#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "wardslam/mapping/map_builder.h"

namespace wardslam::mapping {

/// Runs a MapBuilder in a thread of its own. At most kMaxWaiting views wait: of more, one is left out, if possible one
/// that is no keyframe. For one calling thread.
class AsyncMapBuilder {
 public:
  static constexpr std::size_t kMaxWaiting = 12;

  explicit AsyncMapBuilder(std::unique_ptr<MapBuilder> builder);
  ~AsyncMapBuilder();  ///< What waits is dropped.
  AsyncMapBuilder(const AsyncMapBuilder&) = delete;
  AsyncMapBuilder& operator=(const AsyncMapBuilder&) = delete;

  /// Has the builder do this, in turn. Returns at once; throws what the builder threw.
  void post(std::function<void(MapBuilder&)> work);

  /// The same for work that adds a view, and so may be left out.
  void postView(std::function<void(MapBuilder&)> work, bool isKeyframe);

  /// Views left out.
  [[nodiscard]] std::size_t dropped() const;

  /// Waits until all is done, then gives the builder back. Call nothing else afterwards.
  [[nodiscard]] std::unique_ptr<MapBuilder> finish();

 private:
  struct Task {
    std::function<void(MapBuilder&)> work;
    bool isView = false;
    bool isKeyframe = false;
  };

  void push(Task task);
  void dropOne();
  void run();

  std::unique_ptr<MapBuilder> builder_;

  mutable std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  std::deque<Task> waiting_;
  std::size_t viewsWaiting_ = 0;
  std::size_t dropped_ = 0;
  std::exception_ptr failure_;
  bool stopping_ = false;
  std::thread worker_;
};

}  // namespace wardslam::mapping
