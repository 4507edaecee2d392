#pragma once

#include <opencv2/core.hpp>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::viewer {

/// The map as seen from above one corner (CV_8UC3, BGR): cloud, boxes with names (P10), zones and the camera's way.
/// Needs no display. Throws core::InputError where the machine cannot render.
[[nodiscard]] cv::Mat drawPerspective(const mapping::SemanticMap& map, const cv::Size& size_px = {1500, 1000});

}  // namespace wardslam::viewer
