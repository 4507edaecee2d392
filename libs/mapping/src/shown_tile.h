#pragma once

#include "map_part.h"
#include "semantic_cloud.h"
#include "wardslam/mapping/mapping_options.h"
#include "wardslam/mapping/semantic_cloud_tile.h"

namespace wardslam::mapping {

/// What the map shows of a tile: points seen often and sharply enough, with the things that have a row in the table.
[[nodiscard]] SemanticCloudTile shownOf(const Tile& tile, const Part& part, const CloudOptions& options);

}  // namespace wardslam::mapping
