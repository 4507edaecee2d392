#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "wardslam/segmentation/label_map.h"
#include "wardslam/segmentation/stamped_files.h"

namespace wardslam::segmentation {

/// Looks at some of the masks, spread over all of them, before any is used. What is odd about them, one sentence each:
/// their clock, how numbers are coded, numbers that name no class. Throws core::InputError where the first is no mask,
/// or where masks hold numbers and none of these, in any mask, names a class.
[[nodiscard]] std::vector<std::string> surveyMasks(const std::filesystem::path& folder, const StampedFiles& files,
                                                   const LabelMap& labels);

}  // namespace wardslam::segmentation
