#include "wardslam/pipeline/ini_options.h"

#include <mrpt/config/CConfigFile.h>

#include <sstream>
#include <vector>

#include "wardslam/core/errors.h"

namespace wardslam::pipeline {
namespace {

constexpr const char* kConfig = "config";
constexpr const char* kForGrabber = "rawlog-grabber-ignore";  ///< Tells rawlog-grabber that a section is no sensor.

/// Where a name is that a file gives: beside that file, if it is one.
std::filesystem::path besideIni(const std::filesystem::path& name, const mrpt::config::CConfigFileBase& ini) {
  const auto* file = dynamic_cast<const mrpt::config::CConfigFile*>(&ini);
  return file == nullptr ? name : std::filesystem::path(file->getAssociatedFile()).parent_path() / name;
}

/// Sets root.a.b.c for "a.b.c"; what is missing on the way is made.
void set(const YAML::Node& root, const std::string& path, const std::string& value) {
  std::istringstream keys(path);
  YAML::Node node = root;
  for (std::string key; std::getline(keys, key, '.');) {
    if (node.IsDefined() && !node.IsMap() && !node.IsNull())
      throw core::InputError(path + ": there is nothing below '" + node.as<std::string>("a list") + "'");
    node.reset(YAML::Node(node[key]));  // plain assignment would change the tree
  }
  node = value;
}

}  // namespace

SlamOptions readSlamOptions(const mrpt::config::CConfigFileBase& ini, const std::string& section) {
  if (!ini.sectionExists(section)) throw core::InputError("the .ini file has no section [" + section + "]");
  const std::string name = ini.read_string(section, kConfig, "");
  const auto file = name.empty() ? std::filesystem::path() : besideIni(name, ini);
  const core::ConfigNode base = file.empty() ? core::ConfigNode() : core::ConfigNode::fromFile(file);
  YAML::Node root = base.exists() ? YAML::Clone(base.yaml()) : YAML::Node(YAML::NodeType::Map);

  std::vector<std::string> keys;
  ini.getAllKeys(section, keys);
  for (const auto& key : keys) {
    if (key != kConfig && key != kForGrabber) set(root, key, ini.read_string(section, key, ""));
  }
  return readSlamOptions(core::ConfigNode(root, file.empty() ? std::filesystem::path("[" + section + "]") : file));
}

}  // namespace wardslam::pipeline
