#pragma once

namespace wardslam::mrpt_plugin {

/// Makes every class of WardSLAM that MRPT can create by name known to MRPT's registries: observations, sensors,
/// filters. Loading the library (libwardslam-mrpt.so) does the same; a program that links it calls this to be sure
/// that the linker kept it. To call it again does no harm.
void registerAll();

}  // namespace wardslam::mrpt_plugin
