#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "wardslam/sources/latest_frames.h"
#include "wardslam/sources/live_options.h"
#include "wardslam/sources/observation_source.h"
#include "wardslam/sources/rgbd_camera.h"
#include "wardslam/sources/sensor_configuration.h"

namespace wardslam::sources {

/// Which camera to watch, and how.
struct LiveSensor {
  SensorConfiguration sensor;
  std::vector<std::filesystem::path> plugins;  ///< Libraries with further CGenericSensor classes.
  std::string program = "wardslam-sensor";     ///< Does the grabbing.
  LiveOptions options;
  std::function<bool()> stop = [] { return false; };  ///< Asked all the time; true ends the stream.
};

/// What became of the observations of a camera.
struct LiveCounts {
  std::size_t received = 0;
  std::size_t skipped = 0;   ///< Gave way to newer ones.
  std::size_t unusable = 0;  ///< Without colour or depth, of another size, or not in order of time.
  std::size_t reconnects = 0;
};

/// A camera driven by an MRPT CGenericSensor in a process of its own, since drivers wait for ever or end the process
/// when a camera is unplugged, and a process can be ended where a thread cannot.
///
/// A camera that falls silent, or whose driver fails, is opened again and again with growing pauses; the warning sink
/// hears of it when it is lost and when it is back. Nothing here waits without end.
class LiveSensorSource : public ObservationSource {
 public:
  /// Returns with the first image. Throws core::InputError where the camera cannot be opened or sends nothing usable.
  LiveSensorSource(LiveSensor sensor, const SourceOptions& options);
  ~LiveSensorSource() override;

  /// Waits for the next image, also while the camera is away. Null when asked to stop. Throws core::InputError when the
  /// camera is lost for good or all it sends is unusable.
  [[nodiscard]] std::shared_ptr<mrpt::obs::CObservation3DRangeScan> next() override;
  [[nodiscard]] std::optional<std::size_t> size() const override { return std::nullopt; }

  /// Always empty: see counts().
  [[nodiscard]] const core::EventCounts& damage() const override { return noDamage_; }
  [[nodiscard]] core::SensorTraits sensorTraits() const override {
    return camera_ ? camera_->color.traits() : core::SensorTraits{};
  }

  /// Closes the camera; next() is not to be called any more. Then all that was received was delivered, skipped or
  /// unusable.
  void close();
  [[nodiscard]] LiveCounts counts() const;

 private:
  using Clock = std::chrono::steady_clock;
  using Scan = std::shared_ptr<mrpt::obs::CObservation3DRangeScan>;

  /// Why a connection ended.
  struct Ending {
    std::string sentence;
    bool isFinal = false;  ///< Opening again is of no use.
  };

  // In the thread that watches the camera:
  void watch();
  [[nodiscard]] Ending connect();
  [[nodiscard]] Ending silence() const;
  void welcome(std::string frame);
  void pause(int failures) const;
  void giveUp(const Ending& ending, int failures);
  void say(const std::string& sentence);

  // In the thread that calls next():
  [[nodiscard]] Scan waitForScan();
  [[nodiscard]] std::optional<std::string> whyUnusable(const mrpt::obs::CObservation3DRangeScan& scan) const;
  void endure(const std::string& reason);
  void deliverWarnings();

  LiveSensor sensor_;
  WarningSink warn_;
  std::optional<RgbdCamera> camera_;  ///< Replaces that of the driver.
  const core::EventCounts noDamage_;

  Scan first_;  ///< Waited for by the constructor, delivered by the first next().
  int width_px_ = 0;
  int height_px_ = 0;
  double lastStamp_s_ = 0.0;
  std::optional<Clock::time_point> unusableSince_;
  std::atomic<std::size_t> unusable_{0};

  LatestFrames frames_;
  std::atomic<bool> isStopping_{false};
  std::atomic<std::size_t> reconnects_{0};
  bool isConnected_ = false;                 ///< Images come; used by the watching thread.
  std::optional<Clock::time_point> lostAt_;  ///< Likewise.
  std::mutex mutex_;                         ///< Guards the two below.
  std::vector<std::string> warnings_;
  std::string failure_;
  std::thread thread_;
};

}  // namespace wardslam::sources
