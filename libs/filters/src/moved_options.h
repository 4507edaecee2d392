#pragma once

#include "wardslam/core/options.h"

namespace wardslam::filters {

/// Parameters that filters once had and that are found elsewhere now. Throws core::InputError that says where.
void refuseMovedOptions(const core::ConfigNode& parameters);

}  // namespace wardslam::filters
