#include "wardslam/mrpt_plugin/multi_metric_map.h"

#include <gmock/gmock.h>
#include <mrpt/maps/CColouredOctoMap.h>
#include <mrpt/maps/CColouredPointsMap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/COctoMap.h>

#include <fstream>

#include "semantic_map_encoding.h"
#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/mrpt_plugin/semantic_metric_map.h"

namespace wardslam::mrpt_plugin {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::ThrowsMessage;

TEST(MultiMetricMap, HoldsWhatIsChosen) {
  const auto ward = test::makeWard();
  const auto all = toMetricMaps(ward);
  EXPECT_THAT(all.maps, SizeIs(4));
  EXPECT_EQ(all.mapByClass<CSemanticMap>()->objects().size(), 7U);
  EXPECT_EQ(all.mapByClass<mrpt::maps::CColouredPointsMap>()->size(), 150U);
  EXPECT_LT(all.mapByClass<mrpt::maps::COccupancyGridMap2D>()->getPos(3.1F, 1.0F), 0.1F);  // the wall
  EXPECT_FALSE(all.mapByClass<mrpt::maps::COctoMap>()->isEmpty());
  const auto semanticOnly = toMetricMaps(ward, {true, false, false, false, false});
  EXPECT_THAT(semanticOnly.maps, SizeIs(1));
  MetricMapChoice coloured;
  coloured.octoMap = false;
  coloured.colouredOctoMap = true;
  const auto withColours = toMetricMaps(ward, coloured);
  EXPECT_THAT(withColours.maps, SizeIs(4));
  EXPECT_FALSE(withColours.mapByClass<mrpt::maps::CColouredOctoMap>()->isEmpty());
  auto withoutPlan = ward;
  withoutPlan.floorPlan = {};
  EXPECT_FALSE(toMetricMaps(withoutPlan).mapByClass<mrpt::maps::COccupancyGridMap2D>());
}

TEST(MultiMetricMap, IsOneFile) {
  const test::TemporaryFolder folder;
  const auto ward = test::makeWard();
  exportMetricMaps(ward, folder.path() / "ward.metricmap");
  const auto back = readMetricMaps(folder.path() / "ward.metricmap");
  EXPECT_THAT(back.maps, SizeIs(4));
  EXPECT_EQ(encode(back.mapByClass<CSemanticMap>()->map()), encode(ward));
  std::ofstream(folder.path() / "text.metricmap") << "none";
  for (const char* name : {"text.metricmap", "absent.metricmap"}) {
    EXPECT_THAT([&] { static_cast<void>(readMetricMaps(folder.path() / name)); },
                ThrowsMessage<core::InputError>(HasSubstr(name)));
  }
}

}  // namespace
}  // namespace wardslam::mrpt_plugin
