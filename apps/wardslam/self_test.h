#pragma once

#include <filesystem>

#include "finding.h"

namespace wardslam::apps {

/// Has the whole program work for some seconds, with its defaults: a built-in room is segmented, tracked, mapped,
/// written to a map file in a folder of its own within `folder`, and that is read back and checked. The folder is gone
/// afterwards. Never throws for what it tests.
[[nodiscard]] Finding testTheWholeProgram(const std::filesystem::path& folder);

}  // namespace wardslam::apps
