#pragma once

#include <mrpt/maps/TMetricMapInitializer.h>

#include <string>
#include <vector>

namespace mrpt::config {
class CConfigFileBase;
}

namespace wardslam::mrpt_plugin {

/// The keys by which an .ini file asks for metric maps, `CSemanticMap_count` and those of all maps that MRPT knows.
[[nodiscard]] std::vector<std::string> mapCountKeys();

/// MRPT passes over a key `…_count` that belongs to no map, and there is no such map. Throws core::InputError that
/// names it and the nearest.
void requireKnownMaps(const mrpt::config::CConfigFileBase& ini, const std::string& section);

/// The metric maps that a section asks for, as MRPT reads them, once requireKnownMaps() has seen it. Throws
/// core::InputError, also for what a map finds wrong in its own sections.
[[nodiscard]] mrpt::maps::TSetOfMetricMapInitializers readMapDefinitions(const mrpt::config::CConfigFileBase& ini,
                                                                         const std::string& section);

}  // namespace wardslam::mrpt_plugin
