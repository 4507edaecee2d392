#include "wardslam/pipeline/ini_options.h"

#include <mrpt/config/CConfigFile.h>

#include "wardslam/core/errors.h"
#include "wardslam/core/ini_section.h"

namespace wardslam::pipeline {
namespace {

constexpr const char* kConfig = "config";
constexpr const char* kForGrabber = "rawlog-grabber-ignore";  ///< Tells rawlog-grabber that a section is no sensor.

/// Where a name is that a file gives: beside that file, if it is one.
std::filesystem::path besideIni(const std::filesystem::path& name, const mrpt::config::CConfigFileBase& ini) {
  const auto* file = dynamic_cast<const mrpt::config::CConfigFile*>(&ini);
  return file == nullptr ? name : std::filesystem::path(file->getAssociatedFile()).parent_path() / name;
}

}  // namespace

SlamOptions readSlamOptions(const mrpt::config::CConfigFileBase& ini, const std::string& section) {
  if (!ini.sectionExists(section)) throw core::InputError("the .ini file has no section [" + section + "]");
  const std::string name = ini.read_string(section, kConfig, "");
  const auto file = name.empty() ? std::filesystem::path() : besideIni(name, ini);
  const core::ConfigNode base = file.empty() ? core::ConfigNode() : core::ConfigNode::fromFile(file);
  YAML::Node root = base.exists() ? YAML::Clone(base.yaml()) : YAML::Node(YAML::NodeType::Map);

  core::overlay(root, ini, section, {kConfig, kForGrabber});
  return readSlamOptions(core::ConfigNode(root, file.empty() ? std::filesystem::path("[" + section + "]") : file));
}

}  // namespace wardslam::pipeline
