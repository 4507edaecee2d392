#include "wardslam/mrpt_plugin/map_definitions.h"

#include <gmock/gmock.h>
#include <mrpt/config/CConfigFileMemory.h>

#include <string>

#include "support/complaint.h"
#include "wardslam/mrpt_plugin/register_all.h"

namespace wardslam::mrpt_plugin {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;
using testing::ThrowsMessage;

mrpt::config::CConfigFileMemory iniOf(const std::string& text) {
  mrpt::config::CConfigFileMemory ini;
  ini.setContent(text);
  return ini;
}

TEST(MapDefinitions, KnowMrptsMapsAndOurs) {
  registerAll();
  EXPECT_THAT(mapCountKeys(), IsSupersetOf({"CSemanticMap_count", "occupancyGrid_count", "COctoMap_count",
                                            "colourPointsMap_count", "pointsMap_count"}));
}

TEST(MapDefinitions, AreReadAsMrptReadsThem) {
  EXPECT_EQ(readMapDefinitions(iniOf("[m]\nCSemanticMap_count = 1\noctoMap_count = 2\nother = 3\n"), "m").size(), 3U);
  EXPECT_EQ(readMapDefinitions(iniOf("[m]\nother = 3\n"), "m").size(), 0U);
}

TEST(MapDefinitions, ACountOfNoMapIsNamedWithTheNearest) {
  const auto complaint = [](const std::string& key) {
    return test::complaintOf([&] { return readMapDefinitions(iniOf("[m]\n" + key + " = 1\n"), "m"); });
  };
  EXPECT_THAT(complaint("CSemanticMpa_count"),
              AllOf(HasSubstr("[m]"), HasSubstr("'CSemanticMpa_count'"), HasSubstr("'CSemanticMap_count'")));
  EXPECT_THAT(complaint("octomap_count"), HasSubstr("'octoMap_count'"));
}

TEST(MapDefinitions, WhatAMapFindsWrongIsOneSentenceToo) {
  const auto complaint = test::complaintOf([] {
    return readMapDefinitions(iniOf("[m]\nCSemanticMap_count = 1\n[m_CSemanticMap_00_insertOpts]\ncloud.voxel = 0.1\n"),
                              "m");
  });
  EXPECT_THAT(complaint, AllOf(HasSubstr("[m]"), HasSubstr("voxel_m"), Not(HasSubstr("\n"))));
}

/// MRPT's own reading comes to us where one of the maps is ours.
TEST(MapDefinitions, ACountOfNoMapBesideASemanticMapIsFoundByMrptsReadingToo) {
  registerAll();
  for (const char* name : {"CSemanticMap", "semanticMap", "wardslam::mrpt_plugin::CSemanticMap"}) {
    const auto ini = iniOf("[my_maps]\n" + std::string(name) + "_count = 1\noccupancyGird_count = 1\n");
    mrpt::maps::TSetOfMetricMapInitializers definitions;
    EXPECT_THAT([&] { definitions.loadFromConfigFile(ini, "my_maps"); },
                ThrowsMessage<std::exception>(HasSubstr("'occupancyGrid_count'")))
        << name;
  }
}

}  // namespace
}  // namespace wardslam::mrpt_plugin
