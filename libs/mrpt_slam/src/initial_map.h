#pragma once

#include <mrpt/maps/CSimpleMap.h>

#include <functional>
#include <string>

#include "wardslam/mrpt_slam/map_builder_options.h"
#include "wardslam/pipeline/earlier_map.h"

namespace wardslam::mrpt_slam {

/// What a run begins in: a simple map that holds something, else the `.wardmap` of the options, else nothing. It is
/// held as it is unless the run `updatesTheMap`. `warn` gets one sentence where some of a simple map was left out.
/// Throws core::InputError for a map that cannot be used.
[[nodiscard]] pipeline::EarlierMap initialMap(const mrpt::maps::CSimpleMap& simple,
                                              const MapBuilderConfiguration& configuration, bool updatesTheMap,
                                              const std::function<void(const std::string&)>& warn);

}  // namespace wardslam::mrpt_slam
