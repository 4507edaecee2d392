#include "wardslam/core/profiler.h"

#include <algorithm>
#include <cmath>

namespace wardslam::core {
namespace {

/// Linear interpolation between order statistics; `samples` sorted, not empty.
double quantile(const std::vector<float>& samples, double fraction) {
  const double position = fraction * static_cast<double>(samples.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, samples.size() - 1);
  const double weight = position - static_cast<double>(below);
  return (1.0 - weight) * static_cast<double>(samples[below]) + weight * static_cast<double>(samples[above]);
}

void dropEverySecond(std::vector<float>& samples) {
  for (std::size_t i = 0; 2 * i < samples.size(); ++i) samples[i] = samples[2 * i];
  samples.resize((samples.size() + 1) / 2);
}

}  // namespace

void Profiler::add(const std::string& step, std::chrono::steady_clock::duration duration) {
  const double duration_ms = std::chrono::duration<double, std::milli>(duration).count();
  const std::lock_guard lock(mutex_);
  Samples& samples = steps_[step];
  if (samples.calls++ % samples.stride == 0) samples.kept_ms.push_back(static_cast<float>(duration_ms));
  samples.total_ms += duration_ms;
  if (samples.kept_ms.size() == kMaxSamples) {
    dropEverySecond(samples.kept_ms);
    samples.stride *= 2;
  }
}

std::map<std::string, Profiler::Total> Profiler::totals() const {
  const std::lock_guard lock(mutex_);
  std::map<std::string, Total> result;
  for (const auto& [step, samples] : steps_) result[step] = {samples.calls, samples.total_ms};
  return result;
}

std::map<std::string, Profiler::Statistics> Profiler::statistics() const {
  const std::lock_guard lock(mutex_);
  std::map<std::string, Statistics> result;
  for (const auto& [step, samples] : steps_) {
    std::vector<float> sorted = samples.kept_ms;
    std::sort(sorted.begin(), sorted.end());
    result[step] = {samples.calls, quantile(sorted, 0.5), quantile(sorted, 0.95), samples.total_ms};
  }
  return result;
}

}  // namespace wardslam::core
