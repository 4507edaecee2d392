#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "live_run.h"
#include "support/interruption.h"
#include "wardslam/pipeline/slam_options.h"
#include "wardslam/sources/bag_topics.h"

namespace wardslam::apps {

/// A recording, or a camera, to track through, and where the results go.
struct RecordedRun {
  std::filesystem::path input;        ///< A sensor configuration (.ini) means a camera.
  LiveInput live;                     ///< For a camera; its section is the sensor's label in a rawlog.
  std::filesystem::path camera;       ///< Empty: that of the recording.
  std::optional<double> depthFactor;  ///< Units of depth per metre; replaces what camera file or rawlog say.
  sources::BagTopics topics;          ///< Of a recording of ROS.
  std::filesystem::path out;
  pipeline::SlamOptions options;
  std::filesystem::path map;  ///< Goes on in this map; empty: begins one, map.wardmap in `out`.
  bool localize = false;      ///< Only tracks in `map`, without changing it.
  std::optional<std::size_t> maxFrames;
  std::filesystem::path dynamicTruth;  ///< See DynamicTruth; empty: none.
  bool realtime = false;               ///< Frames come no faster than they were recorded.
  bool view = false;                   ///< Shows the run in a window.
  std::size_t pictureInterval = 0;     ///< Every so many frames a picture; 0: none.
  bool keepPeople = false;             ///< In pictures; else they are blanked.
  bool report = false;                 ///< Writes report.html, too.
  bool isPrivate = false;              ///< Stamps in all files are seconds since the first image; no folders' names.
  std::string progressUnit = "frame";
};

/// Tracks through it and writes a RunFolder. Throws core::InputError when the input was unsound; what could be made of
/// it is written all the same. False: interrupted.
bool perform(const RecordedRun& run, const InterruptionGuard& interruption);

}  // namespace wardslam::apps
