#include "wardslam/mrpt_plugin/map_definitions.h"

#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/maps/TMetricMapTypesRegistry.h>

#include <algorithm>

#include "wardslam/core/errors.h"
#include "wardslam/core/nearest_name.h"
#include "wardslam/mrpt_plugin/register_all.h"

namespace wardslam::mrpt_plugin {
namespace {

const std::string kCount = "_count";

bool isCount(const std::string& key) {
  return key.size() > kCount.size() && key.compare(key.size() - kCount.size(), kCount.size(), kCount) == 0;
}

}  // namespace

std::vector<std::string> mapCountKeys() {
  const std::string ofMrpt = "mrpt::maps::";
  std::vector<std::string> keys;
  for (const auto& registered : mrpt::maps::internal::TMetricMapTypesRegistry::Instance().getAllRegistered()) {
    const std::string& name = registered.first;
    const bool isOfMrpt = name.compare(0, ofMrpt.size(), ofMrpt) == 0;
    keys.push_back((isOfMrpt ? name.substr(ofMrpt.size()) : name) + kCount);
  }
  return keys;
}

void requireKnownMaps(const mrpt::config::CConfigFileBase& ini, const std::string& section) {
  const std::vector<std::string> known = mapCountKeys();
  std::vector<std::string> keys;
  ini.getAllKeys(section, keys);
  for (const std::string& key : keys) {
    if (!isCount(key) || std::find(known.begin(), known.end(), key) != known.end()) continue;
    throw core::InputError("[" + section + "]: '" + key + "': no such map; did you mean '" +
                           core::nearestName(key, known) + "'?");
  }
}

mrpt::maps::TSetOfMetricMapInitializers readMapDefinitions(const mrpt::config::CConfigFileBase& ini,
                                                           const std::string& section) {
  registerAll();
  requireKnownMaps(ini, section);
  mrpt::maps::TSetOfMetricMapInitializers definitions;
  definitions.loadFromConfigFile(ini, section);
  return definitions;
}

}  // namespace wardslam::mrpt_plugin
