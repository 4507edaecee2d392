#pragma once

#include <mrpt/maps/CSimpleMap.h>

#include <cstddef>
#include <filesystem>

#include "wardslam/pipeline/slam_options.h"

namespace wardslam::mrpt_slam {

/// Makes the map that a run can go on in (`.wardmap`) of a simple map, by looking at its scans once more, in order,
/// each from about where the simple map has it (exchange::kKeyframePoseSigma). Every entry needs an RGB-D scan with
/// colour image and range image, in memory or outside, as CMetricMapBuilderSemantic keeps them with
/// MapBuilderOptions::images. `sensorLabel`: of these scans; empty = that of the first.
///
/// Gives back how many of the entries found their place in the map; those that share nothing with it do not. Throws
/// core::InputError where an entry cannot be used, or none shows anything to recognise a place by.
std::size_t makeMapFile(const mrpt::maps::CSimpleMap& simple, const pipeline::SlamOptions& options,
                        const std::string& sensorLabel, const std::filesystem::path& wardmap);

}  // namespace wardslam::mrpt_slam
