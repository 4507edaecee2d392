#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace wardslam::core {

/// How long named steps take ("odometry.track"). Thread-safe. Memory per step is bounded: from kMaxSamples on,
/// every second sample is dropped and only every second, fourth, … new one is kept.
///
/// MRPT's CTimeLogger keeps means; budgets here are medians and 95th percentiles, hence this class.
class Profiler {
 public:
  static constexpr std::size_t kMaxSamples = 1 << 14;

  struct Statistics {
    std::size_t calls = 0;
    double median_ms = 0.0;
    double p95_ms = 0.0;
    double total_ms = 0.0;
  };

  /// Times its own lifetime.
  class Scope {
   public:
    Scope(Profiler& profiler, std::string step) : profiler_(profiler), step_(std::move(step)) {}
    ~Scope() { profiler_.add(step_, std::chrono::steady_clock::now() - start_); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Profiler& profiler_;
    std::string step_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  };

  [[nodiscard]] Scope measure(std::string step) { return {*this, std::move(step)}; }

  /// Calls `work`, timed; returns what it returns.
  template <class Work>
  decltype(auto) time(std::string step, Work&& work) {
    const Scope scope = measure(std::move(step));
    return std::forward<Work>(work)();
  }

  struct Total {
    std::size_t calls = 0;
    double total_ms = 0.0;
  };

  void add(const std::string& step, std::chrono::steady_clock::duration duration);
  /// Cheap: for who asks again and again what has been spent since.
  [[nodiscard]] std::map<std::string, Total> totals() const;
  [[nodiscard]] std::map<std::string, Statistics> statistics() const;

 private:
  struct Samples {
    std::vector<float> kept_ms;
    std::size_t stride = 1;
    std::size_t calls = 0;
    double total_ms = 0.0;
  };

  mutable std::mutex mutex_;
  std::map<std::string, Samples> steps_;
};

}  // namespace wardslam::core
