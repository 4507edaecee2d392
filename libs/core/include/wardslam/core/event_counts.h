#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace wardslam::core {

/// Per-frame trouble that was survived, counted by name ("segmentation.mask_missing").
using EventCounts = std::map<std::string, std::size_t>;

/// Adds every count of `more` to `sum`.
inline void accumulate(EventCounts& sum, const EventCounts& more) {
  for (const auto& [name, count] : more) sum[name] += count;
}

}  // namespace wardslam::core
