#pragma once

#include <opencv2/core.hpp>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::viewer {

/// The map seen from above (CV_8UC3, BGR): the floor plan, zones, what stands on the floor in its own colours, objects
/// as boxes in the colours of their classes with their names, the camera's way, and a scale bar. The map's y axis
/// points up. Equal maps give equal pictures; a map of nothing gives a small empty one.
[[nodiscard]] cv::Mat drawPlan(const mapping::SemanticMap& map);

}  // namespace wardslam::viewer
