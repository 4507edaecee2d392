#pragma once

#include <octomap/OcTree.h>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::exchange {

/// Occupied where the cloud is, free between it and the cameras.
void fillOctree(const mapping::SemanticMap& map, octomap::OcTree& tree);

}  // namespace wardslam::exchange
