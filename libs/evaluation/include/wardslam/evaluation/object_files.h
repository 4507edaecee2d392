#pragma once

#include <filesystem>
#include <vector>

#include "wardslam/evaluation/object_evaluation.h"

namespace wardslam::evaluation {

/// A CSV file with a header line naming at least name, class_id, class_name, xmin, ymin, zmin, xmax, ymax, zmax and
/// either frames_visible and max_pixels, or instance_id: then these are counted in the images of the folder instances
/// beside it, as rawlog-synth writes both. Throws core::InputError naming file and line or column.
[[nodiscard]] std::vector<TrueObject> readTrueObjects(const std::filesystem::path& file);

/// The objects.json of a run (docs/file_formats.md); objects that are gone are left out. Throws core::InputError naming
/// the file.
[[nodiscard]] std::vector<FoundObject> readFoundObjects(const std::filesystem::path& file);

}  // namespace wardslam::evaluation
