#pragma once

#include <filesystem>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::apps {

/// Writes the objects of a map as JSON (docs/file_formats.md). Throws core::InputError when it cannot be written.
void writeObjects(const std::filesystem::path& file, const mapping::SemanticMap& map);

}  // namespace wardslam::apps
