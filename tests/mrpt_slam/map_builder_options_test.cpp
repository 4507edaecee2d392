#include "wardslam/mrpt_slam/map_builder_options.h"

#include <gmock/gmock.h>
#include <mrpt/config/CConfigFileMemory.h>

#include <string>

#include "support/complaint.h"

namespace wardslam::mrpt_slam {
namespace {

using testing::AllOf;
using testing::HasSubstr;

MapBuilderConfiguration read(const std::string& text) {
  mrpt::config::CConfigFileMemory ini;
  ini.setContent(text);
  return readMapBuilderConfiguration(ini, "MappingApplication", {"rawlog_file"});
}

std::string complaint(const std::string& text) {
  return test::complaintOf([&] { return read(text); });
}

TEST(MapBuilderOptions, AreReadInTheStyleOfMrpt) {
  const auto configuration = read(
      "[MappingApplication]\nrawlog_file = ward.rawlog ; of the program\nmap = ward.wardmap\nwaits_for_map = false\n"
      "CSemanticMap_count = 1\noccupancyGrid_count = 1\n[MappingApplication_occupancyGrid_00_creationOpts]\n"
      "resolution = 0.1\n[WardSLAM]\ndeterministic = true\n");
  EXPECT_EQ(configuration.builder.map, "ward.wardmap");
  EXPECT_FALSE(configuration.builder.waits_for_map);
  EXPECT_EQ(configuration.builder.points_px, 6) << "the default";
  EXPECT_EQ(configuration.maps.size(), 2U);
  EXPECT_TRUE(configuration.slam.deterministic);
}

TEST(MapBuilderOptions, AnEmptySectionLeavesTheDefaults) {
  const auto configuration = read("[MappingApplication]\nrawlog_file = ward.rawlog\n");
  EXPECT_EQ(configuration.maps.size(), 0U);
  EXPECT_TRUE(configuration.builder.waits_for_map);
  EXPECT_FALSE(configuration.slam.deterministic);
}

TEST(MapBuilderOptions, AWrongKeyIsNamedWithTheNearest) {
  EXPECT_THAT(complaint("[MappingApplication]\nwait_for_map = true\n"),
              AllOf(HasSubstr("wait_for_map"), HasSubstr("waits_for_map")));
  EXPECT_THAT(complaint("[MappingApplication]\nCSemanticMpa_count = 1\n"),
              AllOf(HasSubstr("'CSemanticMpa_count'"), HasSubstr("'CSemanticMap_count'")));
  EXPECT_THAT(complaint("[MappingApplication]\noccupancyGird_count = 1\n"), HasSubstr("'occupancyGrid_count'"));
  EXPECT_THAT(complaint("[MappingApplication]\nrawlog_file = a\n[WardSLAM]\nfeatures.keypoints = 700\n"),
              AllOf(HasSubstr("keypoints"), HasSubstr("key_points")));
  EXPECT_THAT(complaint("[MappingApplication]\npoints_px = 0\n"), HasSubstr("points_px"));
  EXPECT_THAT(complaint("[ICP]\nmaxIterations = 0\n"), HasSubstr("[MappingApplication]"));
}

}  // namespace
}  // namespace wardslam::mrpt_slam
