#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

namespace mrpt::config {
class CConfigFileBase;
}

namespace wardslam::core {

/// Writes every key of a section of an `.ini` file into a YAML mapping: `a.b = c` becomes root.a.b, in place of what
/// may be there; remarks behind a value (" ; …", " // …") are left out. `except`: keys that are somebody else's. Throws
/// InputError naming a key below one that holds a value.
void overlay(const YAML::Node& root, const mrpt::config::CConfigFileBase& ini, const std::string& section,
             const std::vector<std::string>& except = {});

/// The way back: every value of a YAML mapping as a key of the section.
void writeSection(const YAML::Node& root, mrpt::config::CConfigFileBase& ini, const std::string& section);

}  // namespace wardslam::core
