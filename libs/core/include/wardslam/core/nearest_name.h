#pragma once

#include <string>
#include <vector>

namespace wardslam::core {

/// The candidate with the smallest edit distance (insert, delete, replace) to `name`; empty when there is none.
[[nodiscard]] std::string nearestName(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace wardslam::core
