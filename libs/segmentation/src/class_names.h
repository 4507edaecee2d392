#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wardslam::segmentation {

/// Names by class index, from a dictionary or a list as Python and JSON write them: "{0: 'person', 1: \"cat's eye\"}".
/// Empty where it is neither.
[[nodiscard]] std::vector<std::string> parseClassNames(std::string_view text);

}  // namespace wardslam::segmentation
