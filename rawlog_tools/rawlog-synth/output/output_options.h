#pragma once

#include <filesystem>
#include <optional>

namespace wardslam::synth {

/// What is written, and how much of it.
struct OutputOptions {
  std::filesystem::path file;     ///< FILE.rawlog, or a folder.
  bool isTumFolder = false;       ///< The folder gets the layout of the TUM RGB-D benchmark.
  std::optional<double> seconds;  ///< Unless told, as long as the place proposes.
};

}  // namespace wardslam::synth
