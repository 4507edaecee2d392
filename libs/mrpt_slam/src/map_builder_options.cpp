#include "wardslam/mrpt_slam/map_builder_options.h"

#include <mrpt/config/CConfigFileBase.h>

#include "wardslam/core/errors.h"
#include "wardslam/core/ini_section.h"
#include "wardslam/mrpt_plugin/map_definitions.h"
#include "wardslam/pipeline/ini_options.h"

namespace wardslam::mrpt_slam {
namespace {

constexpr const char* kSlamSection = "WardSLAM";

}  // namespace

MapBuilderConfiguration readMapBuilderConfiguration(const mrpt::config::CConfigFileBase& ini,
                                                    const std::string& section,
                                                    const std::vector<std::string>& ofTheProgram) {
  if (!ini.sectionExists(section)) throw core::InputError("the .ini file has no section [" + section + "]");
  MapBuilderConfiguration configuration;
  configuration.maps = mrpt_plugin::readMapDefinitions(ini, section);

  std::vector<std::string> ofOthers = mrpt_plugin::mapCountKeys();
  ofOthers.insert(ofOthers.end(), ofTheProgram.begin(), ofTheProgram.end());
  YAML::Node root(YAML::NodeType::Map);
  core::overlay(root, ini, section, ofOthers);
  core::readOptions(core::ConfigNode(root, "[" + section + "]"), configuration.builder);

  if (ini.sectionExists(kSlamSection)) configuration.slam = pipeline::readSlamOptions(ini, kSlamSection);
  return configuration;
}

}  // namespace wardslam::mrpt_slam
