#pragma once

#include <filesystem>
#include <string>

#include "wardslam/pipeline/slam_options.h"

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

namespace wardslam::apps {

/// What programs are told about how to find out what moves.
struct FilterArguments {
  std::filesystem::path config;
  std::filesystem::path masks;
  std::filesystem::path model;
  std::string filter;  ///< "on", "geometric", "off", or empty: on where there are masks, else geometric.
  std::string mode;
  bool deterministic = false;
};

/// --config, --masks, --model, --mode.
void addFilterArguments(CLI::App& command, FilterArguments& arguments);

/// The configuration file, overruled by the command line. Throws UsageError for arguments that contradict each other.
/// Tells on standard error, in the name of `program`, where nothing is segmented.
[[nodiscard]] pipeline::SlamOptions effectiveOptions(const FilterArguments& arguments, const std::string& program);

}  // namespace wardslam::apps
