#include "wardslam/mrpt_plugin/map_definitions.h"

#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/maps/TMetricMapTypesRegistry.h>

#include <algorithm>
#include <exception>

#include "wardslam/core/errors.h"
#include "wardslam/core/nearest_name.h"
#include "wardslam/mrpt_plugin/register_all.h"

namespace wardslam::mrpt_plugin {
namespace {

const std::string kCount = "_count";

bool isCount(const std::string& key) {
  return key.size() > kCount.size() && key.compare(key.size() - kCount.size(), kCount.size(), kCount) == 0;
}

/// The sentence in what MRPT has made of an exception: with lines of its own around it, and a location cut off its
/// front.
std::string sentenceOf(const std::exception& error) {
  const std::string text = error.what();
  const std::string mark = "Message: ";
  const std::size_t at = text.find(mark);
  if (at == std::string::npos) return text;
  const std::size_t begin = text.find_first_not_of(": ", at + mark.size());
  return begin == std::string::npos ? text : text.substr(begin, text.find('\n', begin) - begin);
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
  try {
    definitions.loadFromConfigFile(ini, section);
  } catch (const core::InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw core::InputError("metric maps of [" + section + "]: " + sentenceOf(error));
  }
  return definitions;
}

}  // namespace wardslam::mrpt_plugin
