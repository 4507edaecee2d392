#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>
#include <yaml-cpp/yaml.h>

#include <opencv2/imgcodecs.hpp>

#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/map_export.h"

namespace wardslam::exchange {
namespace {

using mrpt::maps::COccupancyGridMap2D;

class ExportFloorPlanTest : public testing::Test {
 protected:
  /// Free before the wall, occupied in it, unknown at the far end of y.
  static void expectWard(const COccupancyGridMap2D& grid) {
    EXPECT_NEAR(grid.getResolution(), 0.05, 1e-6);
    EXPECT_NEAR(grid.getXMin(), -1.0, 1e-5);
    EXPECT_NEAR(grid.getYMin(), -1.0, 1e-5);
    EXPECT_EQ(grid.getSizeX(), 160U);
    EXPECT_EQ(grid.getSizeY(), 120U);
    EXPECT_GT(grid.getPos(0.0F, 0.0F), 0.9F);
    EXPECT_LT(grid.getPos(3.1F, 0.0F), 0.1F);
    EXPECT_LT(grid.getPos(3.025F, 3.975F), 0.1F) << "the last cell of the wall";
    EXPECT_GT(grid.getPos(3.025F, 4.025F), 0.9F) << "the first cell of the gap";
    EXPECT_NEAR(grid.getPos(0.0F, 4.97F), 0.5F, 0.05F);
  }

  mapping::SemanticMap ward_ = test::makeWard();
  test::TemporaryFolder folder_;
};

TEST_F(ExportFloorPlanTest, MrptReadsTheGridmap) {
  const auto file = folder_.path() / "ward.gridmap";
  exportGridmap(ward_, file);
  mrpt::io::CFileGZInputStream in(file.string());
  COccupancyGridMap2D grid;
  mrpt::serialization::archiveFrom(in) >> grid;
  expectWard(grid);
}

TEST_F(ExportFloorPlanTest, CellsOfTheGridmapLieWhereTheyShouldWhateverTheOrigin) {
  ward_.floorPlan.origin_m = {-1.23, 0.37};
  const auto file = folder_.path() / "ward.gridmap";
  exportGridmap(ward_, file);
  mrpt::io::CFileGZInputStream in(file.string());
  COccupancyGridMap2D grid;
  mrpt::serialization::archiveFrom(in) >> grid;
  EXPECT_LT(grid.getPos(2.87F, 1.37F), 0.1F) << "in the wall";
  EXPECT_GT(grid.getPos(2.67F, 1.37F), 0.9F);
  EXPECT_GT(grid.getPos(3.07F, 1.37F), 0.9F);
}

TEST_F(ExportFloorPlanTest, MrptReadsTheRosMap) {
  const auto file = folder_.path() / "ward.yaml";
  exportRosMap(ward_, file);
  COccupancyGridMap2D grid;
  ASSERT_TRUE(grid.loadFromROSMapServerYAML(file.string()));
  expectWard(grid);
}

TEST_F(ExportFloorPlanTest, TheRosMapIsAsMapServerWantsIt) {
  const auto file = folder_.path() / "ward.yaml";
  exportRosMap(ward_, file);
  const auto yaml = YAML::LoadFile(file.string());
  EXPECT_EQ(yaml["image"].as<std::string>(), "ward.pgm");
  EXPECT_DOUBLE_EQ(yaml["resolution"].as<double>(), 0.05);
  EXPECT_EQ(yaml["origin"].as<std::vector<double>>(), (std::vector<double>{-1.0, -1.0, 0.0}));
  EXPECT_EQ(yaml["negate"].as<int>(), 0);
  const cv::Mat image = cv::imread((folder_.path() / "ward.pgm").string(), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(image.size(), cv::Size(160, 120));
  EXPECT_EQ(image.at<unsigned char>(119, 0), 254) << "the lowest row is y = -1";
  EXPECT_EQ(image.at<unsigned char>(119, 82), 0);
  EXPECT_EQ(image.at<unsigned char>(0, 0), 205);
  const double occupied = (255 - 205) / 255.0;
  EXPECT_GT(occupied, yaml["free_thresh"].as<double>()) << "else unknown would count as free";
  EXPECT_LT(occupied, yaml["occupied_thresh"].as<double>());
}

TEST_F(ExportFloorPlanTest, AMapWithoutAFloorPlanHasNothingToWrite) {
  ward_.floorPlan = {};
  EXPECT_THROW(exportGridmap(ward_, folder_.path() / "ward.gridmap"), core::InputError);
  EXPECT_THROW(exportRosMap(ward_, folder_.path() / "ward.yaml"), core::InputError);
}

TEST_F(ExportFloorPlanTest, TheYamlCannotBeNamedLikeItsImage) {
  EXPECT_THROW(exportRosMap(ward_, folder_.path() / "ward.pgm"), core::InputError);
}

}  // namespace
}  // namespace wardslam::exchange
