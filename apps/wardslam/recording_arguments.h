#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "support/filter_arguments.h"
#include "wardslam/pipeline/slam_options.h"
#include "wardslam/sources/bag_topics.h"

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

namespace wardslam::apps {

/// What the commands that track through a recording are told about it.
struct RecordingArguments : FilterArguments {
  std::filesystem::path input;
  std::filesystem::path out;
  std::filesystem::path camera;
  std::optional<double> depthFactor;
  sources::BagTopics topics;
  std::filesystem::path zones;
  std::filesystem::path dynamicTruth;
  std::string startPose;
  std::optional<std::size_t> maxFrames;
};

/// INPUT, --out, --config, --camera, --depth-factor, --color, --depth, --info, --masks, --model, --mode, --zones,
/// --start-pose, --max-frames, --dynamic-truth.
void addRecordingArguments(CLI::App& command, RecordingArguments& arguments);

/// The configuration file, overruled by the command line. Throws UsageError for arguments that contradict each other.
[[nodiscard]] pipeline::SlamOptions effectiveOptions(const RecordingArguments& arguments);

}  // namespace wardslam::apps
