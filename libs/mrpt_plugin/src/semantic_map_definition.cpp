#include <mrpt/config/CConfigFileBase.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <vector>

#include "wardslam/core/errors.h"
#include "wardslam/core/nearest_name.h"
#include "wardslam/mrpt_plugin/map_definitions.h"
#include "wardslam/mrpt_plugin/semantic_metric_map.h"

namespace wardslam::mrpt_plugin {
namespace {

const std::vector<std::string> kOfAllMaps = {"enableSaveAs3DObject", "enableObservationLikelihood",
                                             "enableObservationInsertion"};
const std::vector<std::string> kNames = {"wardslam::mrpt_plugin::CSemanticMap", "CSemanticMap", "semanticMap"};
const std::vector<std::string> kSections = {"_creationOpts", "_insertOpts", "_likelihoodOpts", "_renderOpts"};

[[noreturn]] void failOver(const std::string& where, const std::string& name, const std::vector<std::string>& known) {
  throw core::InputError(where + "; did you mean '" + core::nearestName(name, known) + "'?");
}

void requireSections(const mrpt::config::CConfigFileBase& source, const std::string& prefix) {
  std::vector<std::string> sections;
  source.getAllSections(sections);
  for (const std::string& section : sections) {
    if (section.compare(0, prefix.size(), prefix) != 0) continue;
    const std::string ending = section.substr(prefix.size());
    if (std::find(kSections.begin(), kSections.end(), ending) == kSections.end())
      failOver("[" + section + "]: unknown section", ending, kSections);
  }
}

/// What of all maps is read by MRPT.
void requireCreationKeys(const mrpt::config::CConfigFileBase& source, const std::string& section) {
  std::vector<std::string> keys;
  source.getAllKeys(section, keys);
  for (const std::string& key : keys) {
    if (std::find(kOfAllMaps.begin(), kOfAllMaps.end(), key) == kOfAllMaps.end())
      failOver("[" + section + "]: '" + key + "': unknown key", key, kOfAllMaps);
  }
}

/// Of "SECTION_NAME_00": where the maps are counted.
std::string sectionOfCounts(const std::string& prefix) {
  const std::string unnumbered = prefix.substr(0, prefix.rfind('_'));
  for (const std::string& name : kNames) {
    const std::string ending = "_" + name;
    if (unnumbered.size() <= ending.size()) continue;
    const std::size_t length = unnumbered.size() - ending.size();
    if (unnumbered.compare(length, ending.size(), ending) == 0) return unnumbered.substr(0, length);
  }
  return {};
}

}  // namespace

CSemanticMap::TMapDefinition::TMapDefinition() = default;

void CSemanticMap::TMapDefinition::loadFromConfigFile_map_specific(const mrpt::config::CConfigFileBase& source,
                                                                   const std::string& prefix) {
  requireKnownMaps(source, sectionOfCounts(prefix));
  requireSections(source, prefix);
  requireCreationKeys(source, prefix + "_creationOpts");
  insertionOpts.loadFromConfigFile(source, prefix + "_insertOpts");
  likelihoodOpts.loadFromConfigFile(source, prefix + "_likelihoodOpts");
  renderOpts.loadFromConfigFile(source, prefix + "_renderOpts");
}

void CSemanticMap::TMapDefinition::dumpToTextStream_map_specific(std::ostream& out) const {
  insertionOpts.dumpToTextStream(out);
  likelihoodOpts.dumpToTextStream(out);
  renderOpts.dumpToTextStream(out);
}

core::MapFromDefinition CSemanticMap::internal_CreateFromMapDefinition(const mrpt::maps::TMetricMapInitializer& base) {
  const auto& definition = dynamic_cast<const TMapDefinition&>(base);
  return core::makeMapFromDefinition<CSemanticMap>([&definition](CSemanticMap& map) {
    map.insertionOptions = definition.insertionOpts;
    map.likelihoodOptions = definition.likelihoodOpts;
    map.renderOptions = definition.renderOpts;
  });
}

}  // namespace wardslam::mrpt_plugin
