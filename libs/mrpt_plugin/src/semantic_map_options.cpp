#include "wardslam/mrpt_plugin/semantic_map_options.h"

#include <mrpt/config/CConfigFileBase.h>

#include <ostream>

#include "wardslam/core/ini_section.h"

namespace wardslam::mrpt_plugin {

template <class Options>
void IniOptions<Options>::loadFromConfigFile(const mrpt::config::CConfigFileBase& source, const std::string& section) {
  YAML::Node root(YAML::NodeType::Map);
  core::overlay(root, source, section);
  core::readOptions(core::ConfigNode(root, "[" + section + "]"), static_cast<Options&>(*this));
}

template <class Options>
void IniOptions<Options>::saveToConfigFile(mrpt::config::CConfigFileBase& target, const std::string& section) const {
  core::writeSection(YAML::Load(core::writeOptions(static_cast<const Options&>(*this))), target, section);
}

template <class Options>
void IniOptions<Options>::dumpToTextStream(std::ostream& out) const {
  out << core::writeOptions(static_cast<const Options&>(*this));
}

template struct IniOptions<SemanticInsertionOptions>;
template struct IniOptions<SemanticLikelihoodOptions>;
template struct IniOptions<SemanticRenderOptions>;

}  // namespace wardslam::mrpt_plugin
