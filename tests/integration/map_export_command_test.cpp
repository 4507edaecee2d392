#include <gmock/gmock.h>
#include <mrpt/maps/COctoMap.h>

#include "integration/cli_test_support.h"
#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/exchange/tum_trajectory.h"
#include "wardslam/mrpt_plugin/multi_metric_map.h"
#include "wardslam/mrpt_plugin/semantic_metric_map.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::test {
namespace {

using testing::HasSubstr;

class MapExportCommandTest : public testing::Test {
 protected:
  MapExportCommandTest() { storage::MapFile::create(map_).write(storage::everythingOf(makeWard())); }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  TemporaryFolder folder_;
  std::string map_ = path("ward.wardmap");
};

TEST_F(MapExportCommandTest, WritesEveryFormatThatIsNamedAndNamesWhatItWrote) {
  const auto result = runProgram("wardslam", {"map",
                                              "export",
                                              map_,
                                              "--ply",
                                              path("a.ply"),
                                              "--pcd",
                                              path("a.pcd"),
                                              "--octomap",
                                              path("a.bt"),
                                              "--scene",
                                              path("a.3Dscene"),
                                              "--gridmap",
                                              path("a.gridmap"),
                                              "--ros-map",
                                              path("a.yaml"),
                                              "--geojson",
                                              path("a.geojson"),
                                              "--geopackage",
                                              path("a.gpkg"),
                                              "--csv",
                                              path("a.csv")});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.err, "");
  std::string expected;
  for (const char* name :
       {"a.ply", "a.pcd", "a.bt", "a.3Dscene", "a.gridmap", "a.yaml", "a.geojson", "a.gpkg", "a.csv"}) {
    expected += path(name) + "\n";
    EXPECT_GT(std::filesystem::file_size(path(name)), 0U) << name;
  }
  EXPECT_EQ(result.out, expected);
  EXPECT_TRUE(std::filesystem::exists(path("a.pgm")));
}

TEST_F(MapExportCommandTest, WritesTheMetricMapsThatAreChosen) {
  const auto result = runProgram(
      "wardslam", {"map", "export", map_, "--metric-maps", path("a.metricmap"), "--maps", "semantic,octomap"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  const auto maps = mrpt_plugin::readMetricMaps(path("a.metricmap"));
  ASSERT_EQ(maps.maps.size(), 2U);
  EXPECT_TRUE(maps.mapByClass<mrpt_plugin::CSemanticMap>());
  EXPECT_TRUE(maps.mapByClass<mrpt::maps::COctoMap>());
  const auto wrong =
      runProgram("wardslam", {"map", "export", map_, "--metric-maps", path("b.metricmap"), "--maps", "semantik"});
  EXPECT_EQ(wrong.exitCode, 2);
  EXPECT_THAT(wrong.err, HasSubstr("semantik"));
  EXPECT_FALSE(std::filesystem::exists(path("b.metricmap")));
}

TEST_F(MapExportCommandTest, WritesWhatProgramsOfMrptGoOnWith) {
  const auto ward = makeWard();
  auto content = storage::everythingOf(ward);
  for (std::uint64_t id = 1; id <= 3; ++id) content.views.push_back(makeView(id, ward));
  storage::MapFile::create(map_).write(content);
  const auto result = runProgram("wardslam", {"map", "export", map_, "--metric-maps", path("a.metricmap"),
                                              "--simplemap", path("a.simplemap"), "--graph", path("a.graph")});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  for (const char* name : {"a.metricmap", "a.simplemap", "a.graph"}) EXPECT_TRUE(std::filesystem::exists(path(name)));
  EXPECT_EQ(runProgram("wardslam", {"map", "export", map_, "--trajectory", path("own.txt")}).exitCode, 0);
  EXPECT_EQ(
      runProgram("wardslam", {"map", "export", map_, "--trajectory", path("graph.txt"), "--poses", path("a.graph")})
          .exitCode,
      0);
  const auto own = exchange::readTumTrajectory(path("own.txt"));
  const auto ofGraph = exchange::readTumTrajectory(path("graph.txt"));
  ASSERT_EQ(own.size(), 3U);
  ASSERT_EQ(ofGraph.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(own[i].T_map_cam.isApprox(ward.keyframes.at(i + 1).T_map_cam, 1e-5));
    EXPECT_TRUE(ofGraph[i].T_map_cam.isApprox(own[i].T_map_cam, 1e-5));
  }
}

TEST_F(MapExportCommandTest, SaysWhatIsMissing) {
  EXPECT_EQ(runProgram("wardslam", {"map", "export", map_}).exitCode, 2);
  const auto result = runProgram("wardslam", {"map", "export", map_, "--ply", path("missing/a.ply")});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("cannot be created"));
}

}  // namespace
}  // namespace wardslam::test
