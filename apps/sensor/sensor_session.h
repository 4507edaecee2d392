#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "wardslam/sources/sensor_link.h"

namespace wardslam::apps {

/// What to grab from.
struct SensorRequest {
  std::filesystem::path file;  ///< Configuration of rawlog-grabber (.ini) …
  std::string section;         ///< … and the sensor in it.
  std::vector<std::filesystem::path> plugins;
};

/// Takes a message; false when nobody listens any more.
using MessageSink = std::function<bool(const sources::SensorMessage&)>;

/// Runs the sensor and sends its RGB-D observations until `stop` becomes true or nobody listens. Trouble becomes a last
/// message, a Refusal or a Failure.
void grab(const SensorRequest& request, const MessageSink& send, const std::atomic<bool>& stop);

}  // namespace wardslam::apps
