#pragma once

#include <optional>

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

namespace wardslam::apps {

/// Parses the command line and runs the command it names. Returns the exit code where that is all there is to do (the
/// help or the version was asked for and is printed). Throws UsageError with one sentence that names the word at fault
/// and what was probably meant. `PROGRAM --generate man|bash-completion`, which no help mentions, prints what is
/// installed beside the program.
[[nodiscard]] std::optional<int> parseCommandLine(CLI::App& app, int argc, char** argv);

}  // namespace wardslam::apps
