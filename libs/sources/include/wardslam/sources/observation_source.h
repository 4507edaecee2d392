#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "wardslam/core/event_counts.h"
#include "wardslam/core/sensor_traits.h"
#include "wardslam/sources/bag_topics.h"
#include "wardslam/sources/sensor_counts.h"
#include "wardslam/sources/stereo_options.h"

namespace mrpt::obs {
class CObservation3DRangeScan;
}

namespace wardslam::sources {

/// A stream of RGB-D observations, in order of time.
class ObservationSource {
 public:
  virtual ~ObservationSource() = default;

  /// The next observation with both an intensity image and a range image, or null at the end. An observation that
  /// cannot be read is skipped, counted in damage() and, the first time of each kind, told to the warning sink.
  [[nodiscard]] virtual std::shared_ptr<mrpt::obs::CObservation3DRangeScan> next() = 0;

  /// How many observations there are to come at the start, where that is known beforehand.
  [[nodiscard]] virtual std::optional<std::size_t> size() const = 0;

  /// Unreadable input met so far, by kind ("sources.image_missing"). Empty: all was well.
  [[nodiscard]] virtual const core::EventCounts& damage() const = 0;

  /// The sensors met so far; the observations of one of them are delivered. Empty where there can be no other.
  [[nodiscard]] virtual SensorCounts sensors() const { return {}; }

  /// What is known of the camera that its observations do not tell.
  [[nodiscard]] virtual core::SensorTraits sensorTraits() const { return {}; }

  /// Images a second, by which files that number images instead of telling the time are to be taken.
  [[nodiscard]] virtual double rate_hz() const { return 30.0; }
};

/// Receives one sentence about survived trouble; the program decides where it goes. Called from the thread that
/// calls openSource() or next().
using WarningSink = std::function<void(const std::string&)>;

/// Receives one sentence about what had to be assumed of the input (a camera, a unit, a clock). Called from any thread.
using NoteSink = std::function<void(const std::string&)>;

struct SourceOptions {
  std::optional<std::filesystem::path> camera;  ///< Camera file: replaces the calibration of the recording.
  WarningSink warn = [](const std::string&) {};
  StereoOptions stereo = {};  ///< How depth is made of the images of a stereo camera.
  NoteSink note = [](const std::string&) {};
  std::optional<double> depth_units_per_m = {};  ///< Replaces the unit that the recording or its camera file tells.
  std::string sensor = {};                       ///< Label of the sensor in a rawlog; empty: the first.
  BagTopics topics = {};                         ///< Of a recording of ROS.
};

/// Opens a TUM folder, a .rawlog file or a recording of ROS (bags::isBag()), told apart by what the path is (other
/// files are named by their first bytes), and decodes images ahead in a thread of its own. Throws core::InputError.
/// MRPT resolves external images of a rawlog through one process-wide folder, which this sets: only one rawlog with
/// external images can be open at a time.
[[nodiscard]] std::unique_ptr<ObservationSource> openSource(const std::filesystem::path& input,
                                                            const SourceOptions& options);

}  // namespace wardslam::sources
