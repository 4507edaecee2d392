#include "places/place.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>

#include "wardslam/core/data_files.h"
#include "wardslam/core/label_space.h"

namespace wardslam::synth {
namespace {

/// COCO's names and those of config/labels/hospital.yaml.
std::map<int, std::string> publishedNames() {
  std::map<int, std::string> names;
  const auto coco = core::LabelSpace::coco();
  for (int id = 1; id <= 90; ++id) names[id] = coco.name(static_cast<core::ClassId>(id));
  std::ifstream file(core::findDataFile("labels/hospital.yaml"));
  const std::regex entry("  (\\d+): (\\w+)");
  std::smatch found;
  for (std::string line; std::getline(file, line);) {
    if (std::regex_match(line, found, entry)) names[std::stoi(found[1])] = found[2];
  }
  return names;
}

/// All that stands in brackets behind an entity of config/knowledge/hospital.yaml.
std::set<std::string> labelsOfEntities() {
  std::set<std::string> labels;
  std::ifstream file(core::findDataFile("knowledge/hospital.yaml"));
  bool areEntities = false;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && line.front() != ' ' && line.front() != '#') areEntities = line == "entities:";
    const auto bracket = line.find('[');
    if (!areEntities || bracket == std::string::npos) continue;
    const std::regex word("[^,\\[\\] ][^,\\[\\]]*");
    for (std::sregex_iterator it(line.begin() + static_cast<long>(bracket), line.end(), word), end; it != end; ++it)
      labels.insert(it->str());
  }
  return labels;
}

std::map<int, std::set<std::string>> classesOf(const std::string& place) {
  PlaceOptions options;
  options.name = place;
  options.hospital.people = Density::Crowd;
  const Setting setting = buildPlace(options, {});
  std::map<int, std::set<std::string>> classes;
  for (const Thing& thing : setting.scene.things) {
    if (thing.label.classId != 0) classes[thing.label.classId].insert(thing.label.className);
  }
  for (const auto& actor : setting.scene.actors) classes[actor->label().classId].insert(actor->label().className);
  return classes;
}

TEST(Places, GiveEachClassTheNameThatTheLabelsAndTheKnowledgeHave) {
  const auto names = publishedNames();
  const auto known = labelsOfEntities();
  ASSERT_GT(known.size(), 50U);
  for (const Place& place : places()) {
    for (const auto& [id, itsNames] : classesOf(place.name)) {
      ASSERT_EQ(itsNames.size(), 1U) << place.name << ": two classes have the id " << id;
      ASSERT_EQ(names.count(id), 1U) << place.name << ": " << *itsNames.begin();
      EXPECT_EQ(names.at(id), *itsNames.begin()) << place.name << ", " << id;
      EXPECT_EQ(known.count(*itsNames.begin()), 1U) << place.name << ": " << *itsNames.begin();
    }
  }
}

}  // namespace
}  // namespace wardslam::synth
