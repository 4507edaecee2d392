#pragma once

namespace wardslam::mrpt_plugin {

/// Makes WardSLAM's classes known to MRPT's registries, that MRPT can create them by name: observations, the metric
/// map, filters. Loading libwardslam-mrpt.so does the same, and adds the sensor; a program that links this library
/// calls this to be sure that the linker kept it. To call it again does no harm.
void registerAll();

}  // namespace wardslam::mrpt_plugin
