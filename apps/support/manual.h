#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

namespace wardslam::apps {

/// The manual page of a program, section 1, as troff: what its --help and those of its commands say.
[[nodiscard]] std::string manualPage(const CLI::App& app);

/// What makes bash complete the words of a program: commands, options, and values where these are names to choose from.
[[nodiscard]] std::string bashCompletion(const CLI::App& app);

}  // namespace wardslam::apps
