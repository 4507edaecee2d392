#include "live_run.h"

#include <chrono>
#include <cstdio>
#include <utility>

#include "support/told_at_once.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::apps {
namespace {

constexpr const char* kLatency = "latency";

std::function<bool()> stopper(const InterruptionGuard& interruption, std::optional<double> seconds) {
  using Clock = std::chrono::steady_clock;
  return [&interruption, seconds, start = Clock::now()] {
    return interruption.requested() ||
           (seconds && std::chrono::duration<double>(Clock::now() - start).count() >= *seconds);
  };
}

}  // namespace

LiveRun::LiveRun(const std::filesystem::path& ini, const LiveInput& input, const sources::LiveOptions& live,
                 sources::SourceOptions options, const InterruptionGuard& interruption) {
  sources::LiveSensor sensor;
  sensor.sensor = sources::readSensorConfiguration(ini, input.section);
  sensor.plugins = input.plugins;
  sensor.options = live;
  sensor.stop = stopper(interruption, input.seconds);
  options.warn = tellAtOnce;  // somebody may stand beside the robot with the plug in the hand
  source_.emplace(std::move(sensor), options);
}

void LiveRun::onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) {
  if (!odometry.hasPose()) return;
  latency_.add(kLatency, mrpt::Clock::now() - core::toMrptTime(frame.stamp_s));
}

core::Profiler::Statistics LiveRun::latency() const {
  const auto statistics = latency_.statistics();
  const auto latency = statistics.find(kLatency);
  return latency == statistics.end() ? core::Profiler::Statistics{} : latency->second;
}

std::string LiveRun::closingLine(std::size_t processed) const {
  const auto counts = this->counts();
  char text[256];
  std::snprintf(text, sizeof text,
                "%zu images came, %zu were worked on, %zu skipped, %zu unusable; %zu reconnects; from capture to pose "
                "%.0f ms (median), %.0f ms (95th percentile)",
                counts.received, processed, counts.skipped, counts.unusable, counts.reconnects, latency().median_ms,
                latency().p95_ms);
  return text;
}

}  // namespace wardslam::apps
