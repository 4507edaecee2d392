#pragma once

#include <future>
#include <utility>

namespace wardslam::core {

/// Work done beside the caller, one piece at a time: a second one is begun when the first is through. Ends before the
/// object does; so let it be the last member of what it works on.
template <class Result>
class SideJob {
 public:
  /// Returns at once unless the last piece is still in work, whose result, or failure, is lost if nobody took it.
  template <class Work>
  void start(Work&& work) {
    if (result_.valid()) result_.wait();
    result_ = std::async(std::launch::async, std::forward<Work>(work));
  }

  /// Whether there is a result to take, now or when the work is done.
  [[nodiscard]] bool isStarted() const { return result_.valid(); }

  /// Waits; throws what the work threw. Only when started.
  Result take() { return result_.get(); }

 private:
  std::future<Result> result_;
};

}  // namespace wardslam::core
