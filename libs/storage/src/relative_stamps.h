#pragma once

#include "wardslam/storage/map_file.h"

namespace wardslam::storage {

/// From UNIX seconds to seconds since `origin_s`: the stamps of keyframes and objects. "Never" (0) stays that.
void makeStampsRelative(MapChanges& changes, double origin_s);
void makeStampsRelative(mapping::MapMemory& memory, double origin_s);

}  // namespace wardslam::storage
