#include "metric_maps.h"

#include <gmock/gmock.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/maps/CColouredPointsMap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/COctoMap.h>
#include <mrpt/maps/CSimplePointsMap.h>

#include "support/hand_made_map.h"
#include "wardslam/exchange/map_export.h"
#include "wardslam/mrpt_plugin/map_definitions.h"
#include "wardslam/mrpt_plugin/semantic_metric_map.h"

namespace wardslam::mrpt_slam {
namespace {

using mrpt_plugin::CSemanticMap;
using testing::SizeIs;

TEST(MetricMaps, AreThoseThatAreAskedForWithTheirOptions) {
  mrpt::config::CConfigFileMemory ini;
  ini.setContent(
      "[maps]\nCSemanticMap_count = 1\ncolourPointsMap_count = 1\npointsMap_count = 1\noctoMap_count = 1\n"
      "occupancyGrid_count = 1\n[maps_CSemanticMap_00_renderOpts]\ncolor = class\n"
      "[maps_occupancyGrid_00_creationOpts]\nresolution = 0.1\n"
      "[maps_octoMap_00_creationOpts]\nresolution = 0.2\n");
  const auto ward = test::makeWard();
  const auto all = makeMetricMaps(mrpt_plugin::readMapDefinitions(ini, "maps"), ward);
  ASSERT_THAT(all.maps, SizeIs(5));
  const auto semantic = all.mapByClass<CSemanticMap>();
  EXPECT_EQ(semantic->objects().size(), 7U);
  EXPECT_EQ(semantic->renderOptions.color, exchange::CloudColor::Class);
  EXPECT_EQ(all.mapByClass<mrpt::maps::CColouredPointsMap>()->size(), 150U);
  EXPECT_FALSE(all.mapByClass<mrpt::maps::CSimplePointsMap>()->isEmpty());
  EXPECT_NEAR(all.mapByClass<mrpt::maps::COctoMap>()->getResolution(), 0.2, 1e-9);
  const auto grid = all.mapByClass<mrpt::maps::COccupancyGridMap2D>();
  EXPECT_NEAR(grid->getResolution(), 0.1F, 1e-6F);
  int occupied = 0;
  for (int y = 0; y < 200; ++y) occupied += grid->getPos(3.05F, -1.0F + 0.05F * static_cast<float>(y)) < 0.4F ? 1 : 0;
  EXPECT_GT(occupied, 5) << "of the wall";
}

TEST(MetricMaps, WithoutDefinitionsThereIsASemanticMap) {
  const auto all = makeMetricMaps({}, test::makeWard());
  ASSERT_THAT(all.maps, SizeIs(1));
  EXPECT_EQ(all.mapByClass<CSemanticMap>()->objects().size(), 7U);
}

TEST(MetricMaps, OfAnEmptyMapAreEmpty) {
  const auto all = makeMetricMaps({}, {});
  EXPECT_TRUE(all.mapByClass<CSemanticMap>()->isEmpty());
}

}  // namespace
}  // namespace wardslam::mrpt_slam
