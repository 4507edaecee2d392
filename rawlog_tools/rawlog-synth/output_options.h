#pragma once

#include <filesystem>
#include <optional>

namespace wardslam::synth {

/// What is written, and how much of it.
struct OutputOptions {
  std::filesystem::path file;     ///< FILE.rawlog
  std::optional<double> seconds;  ///< Unless told, as long as the place proposes.
};

}  // namespace wardslam::synth
