#include "wardslam/core/ini_section.h"

#include <mrpt/config/CConfigFileBase.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "wardslam/core/errors.h"

namespace wardslam::core {
namespace {

/// Sets root.a.b.c for "a.b.c"; what is missing on the way is made.
void set(const YAML::Node& root, const std::string& path, const std::string& value) {
  std::istringstream keys(path);
  YAML::Node node = root;
  for (std::string key; std::getline(keys, key, '.');) {
    if (node.IsDefined() && !node.IsMap() && !node.IsNull())
      throw InputError(path + ": there is nothing below '" + node.as<std::string>("a list") + "'");
    node.reset(YAML::Node(node[key]));  // plain assignment would change the tree
  }
  node = value;
}

/// The value without a remark behind it ("0.1  ; metres", "0.1 // metres"), as MRPT's own numbers are read.
std::string withoutRemark(const std::string& value) {
  static const std::regex kRemark("\\s+(;|//).*$");
  return std::regex_replace(value, kRemark, "");
}

void write(const YAML::Node& node, const std::string& path, mrpt::config::CConfigFileBase& ini,
           const std::string& section) {
  if (!node.IsMap()) return ini.write(section, path, node.as<std::string>(""));
  for (const auto& entry : node) {
    const auto key = entry.first.as<std::string>();
    write(entry.second, path.empty() ? key : path + "." + key, ini, section);
  }
}

}  // namespace

void overlay(const YAML::Node& root, const mrpt::config::CConfigFileBase& ini, const std::string& section,
             const std::vector<std::string>& except) {
  std::vector<std::string> keys;
  ini.getAllKeys(section, keys);
  for (const auto& key : keys) {
    if (std::find(except.begin(), except.end(), key) != except.end()) continue;
    set(root, key, withoutRemark(ini.read_string(section, key, "")));
  }
}

void writeSection(const YAML::Node& root, mrpt::config::CConfigFileBase& ini, const std::string& section) {
  write(root, "", ini, section);
}

}  // namespace wardslam::core
