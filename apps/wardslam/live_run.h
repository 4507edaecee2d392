#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "support/interruption.h"
#include "wardslam/core/profiler.h"
#include "wardslam/pipeline/frame_observer.h"
#include "wardslam/sources/live_sensor_source.h"

namespace wardslam::apps {

/// What the user says about a camera.
struct LiveInput {
  std::string section;                         ///< Of the sensor in the .ini file; empty: the only one.
  std::vector<std::filesystem::path> plugins;  ///< Libraries with further sensor classes.
  std::optional<double> seconds;               ///< The run ends after so long.

  [[nodiscard]] bool isGiven() const { return !section.empty() || !plugins.empty() || seconds; }
};

/// A run on a camera: where its images come from, and how it kept up with them.
class LiveRun : public pipeline::FrameObserver {
 public:
  /// Returns when images come. Throws core::InputError. The options' warning sink is replaced by standard error.
  LiveRun(const std::filesystem::path& ini, const LiveInput& input, const sources::LiveOptions& live,
          sources::SourceOptions options, const InterruptionGuard& interruption);

  [[nodiscard]] sources::LiveSensorSource& source() { return *source_; }

  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override;

  [[nodiscard]] sources::LiveCounts counts() const { return source_->counts(); }

  /// From capture, as stamped by the driver, to the pose, over all frames that got one.
  [[nodiscard]] core::Profiler::Statistics latency() const;

  /// "1783 images came, 1702 were worked on, …".
  [[nodiscard]] std::string closingLine(std::size_t processed) const;

 private:
  std::optional<sources::LiveSensorSource> source_;
  core::Profiler latency_;
};

}  // namespace wardslam::apps
