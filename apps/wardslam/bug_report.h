#pragma once

#include <filesystem>

#include "finding.h"

namespace wardslam::apps {

/// Writes what helps to understand a fault into one text: what was found out about the computer and, of a run's folder
/// (may be empty), summary, configuration and how the map is. No pictures, no map, no way of the camera, no names of
/// folders. Throws core::InputError when it cannot be written.
void writeBugReport(const std::filesystem::path& file, const Findings& findings, const std::filesystem::path& run);

}  // namespace wardslam::apps
