#pragma once

#include <memory>
#include <vector>

#include "wardslam/odometry/map_update.h"

namespace wardslam::pipeline {

/// Several threads read them, and none copies them: a loop moves the whole map.
using SharedUpdates = std::vector<std::shared_ptr<const odometry::MapUpdate>>;

}  // namespace wardslam::pipeline
