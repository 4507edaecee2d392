#pragma once

#include <filesystem>

#include "wardslam/storage/map_file.h"

namespace wardslam::apps {

/// A saved map, to be asked or exported. The floor plan of a run that was killed before it drew one is made up for.
/// Throws core::InputError.
[[nodiscard]] mapping::SemanticMap readStoredMap(const std::filesystem::path& file, storage::CloudPart cloud);

}  // namespace wardslam::apps
