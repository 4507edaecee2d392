#pragma once

#include <opencv2/core.hpp>

#include "mission.h"
#include "simulation.h"
#include "wardslam/mapping/semantic_map.h"

namespace wardslam::nav_demo {

/// A run over the map seen from above (CV_8UC3, BGR): the ways of robot and people, where everybody was every few
/// seconds, the planned way, the spot, and what came of it.
[[nodiscard]] cv::Mat drawRun(const mapping::SemanticMap& map, const Mission& mission, const SimulationOptions& options,
                              const RunRecord& run);

}  // namespace wardslam::nav_demo
