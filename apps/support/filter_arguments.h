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
  std::filesystem::path classes;  ///< What numbers of classes mean.
  bool noNetwork = false;         ///< Nothing is segmented unless there are masks.
  std::string filter;             ///< "on", "geometric", "off", or empty: on where something segments, else geometric.
  std::string mode;
  bool deterministic = false;
};

/// --config, --masks, --model, --classes, --no-network, --mode.
void addFilterArguments(CLI::App& command, FilterArguments& arguments);

/// The configuration file, overruled by the command line. Throws UsageError for arguments that contradict each other.
/// Where nobody said what segments, tells on standard error, in the name of `program`, what does; likewise what has to
/// be assumed of masks and networks.
[[nodiscard]] pipeline::SlamOptions effectiveOptions(const FilterArguments& arguments, const std::string& program);

/// Throws UsageError where people are to be blanked and nothing finds them. `whatShows`: "pictures show".
void requireSomebodyLooksForPeople(const pipeline::SlamOptions& options, bool keepsPeople,
                                   const std::string& whatShows);

}  // namespace wardslam::apps
