#pragma once

#include <string>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::viewer {

/// Shows the map in a window until it is closed. Throws core::InputError where there is no display.
void showMap(const mapping::SemanticMap& map, const std::string& title);

}  // namespace wardslam::viewer
