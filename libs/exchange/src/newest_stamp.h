#pragma once

#include <string>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::exchange {

/// When the map saw its last keyframe, ISO 8601 in UTC with milliseconds; so the same map makes the same file.
[[nodiscard]] std::string newestStampOf(const mapping::SemanticMap& map);

}  // namespace wardslam::exchange
