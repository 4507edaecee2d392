#include "wardslam/sources/live_sensor_source.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "observation_camera.h"
#include "observation_check.h"
#include "sensor_calibration.h"
#include "sensor_process.h"
#include "wardslam/core/data_files.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/sources/sensor_link.h"

namespace wardslam::sources {
namespace {

using namespace std::chrono_literals;
using mrpt::obs::CObservation3DRangeScan;

constexpr auto kSlice = 20ms;  ///< Between two looks whether to stop.

std::string seconds(double duration_s) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g s", duration_s);
  return text;
}

std::chrono::steady_clock::duration toDuration(double duration_s) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(duration_s));
}

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<std::string> commandOf(const LiveSensor& live) {
  std::vector<std::string> command = {core::findProgram(live.program).string(), live.sensor.file.string(),
                                      live.sensor.section};
  for (const auto& plugin : live.plugins) command.push_back(plugin.string());
  return command;
}

}  // namespace

LiveSensorSource::LiveSensorSource(LiveSensor sensor, const SourceOptions& options)
    : sensor_(std::move(sensor)),
      warn_(options.warn),
      frames_(static_cast<std::size_t>(sensor_.options.max_waiting_frames)) {
  requireUsableSensor(sensor_.sensor, options.camera.has_value());
  if (options.camera) camera_ = readRgbdCamera(*options.camera, options.note);
  thread_ = std::thread([this] { watch(); });
  try {
    first_ = waitForScan();
  } catch (...) {
    close();
    throw;
  }
}

LiveSensorSource::~LiveSensorSource() { close(); }

void LiveSensorSource::close() {
  isStopping_ = true;
  if (thread_.joinable()) thread_.join();
  frames_.discard();
}

LiveCounts LiveSensorSource::counts() const { return {frames_.pushed(), frames_.skipped(), unusable_, reconnects_}; }

/// Opens the camera again until told to stop, or given up.
void LiveSensorSource::watch() {
  for (int failures = 0; !isStopping_; ++failures) {
    const Ending ending = connect();
    if (isStopping_) return;
    if (std::exchange(isConnected_, false)) {
      failures = 0;
      lostAt_ = Clock::now();
      say(ending.sentence + "; trying to open it again");
    }
    const bool wasNeverThere = !lostAt_;
    if (ending.isFinal || wasNeverThere || failures >= sensor_.options.max_attempts) return giveUp(ending, failures);
    pause(failures);
  }
}

void LiveSensorSource::giveUp(const Ending& ending, int failures) {
  {
    const std::lock_guard lock(mutex_);
    failure_ = ending.sentence;
    if (failures > 0) failure_ += " (after " + std::to_string(failures) + " attempts to open it again)";
  }
  frames_.close();
}

/// From opening to trouble.
LiveSensorSource::Ending LiveSensorSource::connect() {
  try {
    SensorProcess process(commandOf(sensor_));
    SensorMessageReader reader(process.output());
    auto deadline = Clock::now() + toDuration(sensor_.options.open_timeout_s);
    SensorMessage message;
    while (!isStopping_) {
      const auto status = reader.read(message, kSlice);
      if (status == SensorMessageReader::Status::Closed) {
        return {sensor_.sensor.place + ": the driver " + process.howItEnded()};
      }
      if (status == SensorMessageReader::Status::Nothing) {
        if (Clock::now() < deadline) continue;
        process.kill();
        return silence();
      }
      if (message.kind != SensorMessage::Kind::Observation) {
        return {sensor_.sensor.place + ": " + message.bytes, message.kind == SensorMessage::Kind::Refusal};
      }
      welcome(std::move(message.bytes));
      deadline = Clock::now() + toDuration(sensor_.options.silence_timeout_s);
    }
    return {};
  } catch (const core::InputError& error) {
    return {error.what(), true};
  }
}

LiveSensorSource::Ending LiveSensorSource::silence() const {
  if (isConnected_) {
    return {sensor_.sensor.place + ": no image for " + seconds(sensor_.options.silence_timeout_s) +
            "; the camera is unplugged or its driver hangs"};
  }
  std::string hint = "; is another program using it?";
  if (sensor_.sensor.driver == "COpenNI2Sensor") {
    hint = "; COpenNI2Sensor waits for ever where a camera has no infrared stream or not this width, height and fps";
  }
  return {sensor_.sensor.place + ": the camera sent no image within " + seconds(sensor_.options.open_timeout_s) + hint};
}

void LiveSensorSource::welcome(std::string frame) {
  frames_.push(std::move(frame));
  if (std::exchange(isConnected_, true) || !lostAt_) return;
  ++reconnects_;
  say(sensor_.sensor.place + ": the camera is back after " + seconds(secondsSince(*lostAt_)));
}

void LiveSensorSource::pause(int failures) const {
  const auto& options = sensor_.options;
  const double pause_s = std::min(options.longest_pause_s, std::ldexp(options.first_pause_s, std::min(failures, 30)));
  const auto end = Clock::now() + toDuration(pause_s);
  while (!isStopping_ && Clock::now() < end) std::this_thread::sleep_for(kSlice);
}

void LiveSensorSource::say(const std::string& sentence) {
  const std::lock_guard lock(mutex_);
  warnings_.push_back(sentence);
}

LiveSensorSource::Scan LiveSensorSource::next() {
  if (first_) return std::exchange(first_, nullptr);
  return waitForScan();
}

LiveSensorSource::Scan LiveSensorSource::waitForScan() {
  while (!sensor_.stop()) {
    const auto frame = frames_.pop(kSlice);
    deliverWarnings();
    if (!frame) {
      if (!frames_.isDrained()) continue;
      const std::lock_guard lock(mutex_);
      throw core::InputError(failure_);
    }
    Scan scan = unpackObservation(*frame);
    if (scan && camera_) replaceCamera(*scan, camera_->color);
    if (const auto reason = scan ? whyUnusable(*scan) : "cannot be read") {
      endure(*reason);
      continue;
    }
    unusableSince_.reset();
    width_px_ = static_cast<int>(scan->intensityImage.getWidth());
    height_px_ = static_cast<int>(scan->intensityImage.getHeight());
    lastStamp_s_ = core::fromMrptTime(scan->timestamp);
    return scan;
  }
  return nullptr;
}

std::optional<std::string> LiveSensorSource::whyUnusable(const CObservation3DRangeScan& scan) const {
  if (auto reason = sources::whyUnusable(scan)) return reason;
  if (core::fromMrptTime(scan.timestamp) <= lastStamp_s_) return "is not younger than the one before it";
  const auto width_px = static_cast<int>(scan.intensityImage.getWidth());
  const auto height_px = static_cast<int>(scan.intensityImage.getHeight());
  if (width_px_ == 0 || (width_px == width_px_ && height_px == height_px_)) return std::nullopt;
  return "has images of " + std::to_string(width_px) + "x" + std::to_string(height_px) +
         " pixels, but the run began with " + std::to_string(width_px_) + "x" + std::to_string(height_px_);
}

/// Single bad observations are left out; a camera that sends nothing else is set up wrongly.
void LiveSensorSource::endure(const std::string& reason) {
  ++unusable_;
  if (!unusableSince_) unusableSince_ = Clock::now();
  if (secondsSince(*unusableSince_) < sensor_.options.silence_timeout_s) return;
  throw core::InputError(sensor_.sensor.place + ": every observation for " +
                         seconds(sensor_.options.silence_timeout_s) + " " + reason);
}

void LiveSensorSource::deliverWarnings() {
  std::vector<std::string> warnings;
  {
    const std::lock_guard lock(mutex_);
    warnings.swap(warnings_);
  }
  if (!warn_) return;
  for (const std::string& sentence : warnings) warn_(sentence);
}

}  // namespace wardslam::sources
