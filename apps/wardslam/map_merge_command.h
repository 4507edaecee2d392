#pragma once

#include <filesystem>
#include <optional>

#include "wardslam/merging/alignment.h"

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

namespace wardslam::apps {

/// `wardslam map merge` and `wardslam map align`.
void addMapMergeCommands(CLI::App& mapCommand);

/// With a line of progress; Ctrl-C ends it with a sentence.
[[nodiscard]] std::optional<merging::Alignment> alignWithProgress(const std::filesystem::path& a,
                                                                  const std::filesystem::path& b,
                                                                  const std::filesystem::path& config);

}  // namespace wardslam::apps
