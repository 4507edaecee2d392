#include "wardslam/exchange/metric_maps.h"

#include <gtest/gtest.h>
#include <mrpt/maps/CColouredOctoMap.h>
#include <mrpt/maps/CColouredPointsMap.h>
#include <mrpt/maps/COctoMap.h>
#include <octomap/OcTree.h>

#include <cstdint>

#include "octree.h"
#include "support/hand_made_map.h"
#include "wardslam/mapping/cloud_in_map.h"

namespace wardslam::exchange {
namespace {

TEST(MetricMaps, PointsHaveTheirPlacesAndColours) {
  const auto ward = test::makeWard();
  const auto points = toColouredPoints(ward);
  ASSERT_EQ(points->size(), 150U);
  float x = 0;
  float y = 0;
  float z = 0;
  float red = 0;
  float green = 0;
  float blue = 0;
  points->getPointRGB(57, x, y, z, red, green, blue);  // the eighth of the second tile
  const auto& keyframe = ward.keyframes.at(2);
  const Eigen::Vector3d p_m = keyframe.T_map_cam * ward.cloud.at(2).points[7].p_cam_m.cast<double>();
  EXPECT_LT((Eigen::Vector3f(x, y, z) - p_m.cast<float>()).norm(), 1e-5F);
  EXPECT_NEAR(red * 255, 7, 0.01);
  EXPECT_NEAR(green * 255, 100, 0.01);
  EXPECT_NEAR(blue * 255, 200, 0.01);
}

TEST(MetricMaps, ColouredOctoMapHasTheColoursOfTheCloud) {
  const auto ward = test::makeWard();
  const auto octoMap = toColouredOctoMap(ward, 0.01);
  int seen = 0;
  mapping::forEachCloudPoint(ward, [&](const Eigen::Vector3f& p_m, const mapping::SemanticPoint& point) {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    double occupancy = 0.0;
    ASSERT_TRUE(octoMap->getPointColour(p_m.x(), p_m.y(), p_m.z(), red, green, blue));
    ASSERT_TRUE(octoMap->getPointOccupancy(p_m.x(), p_m.y(), p_m.z(), occupancy));
    EXPECT_GT(occupancy, 0.5);
    EXPECT_NEAR(red, point.color_rgb[0], 1);
    EXPECT_EQ(green, 100);
    EXPECT_EQ(blue, 200);
    ++seen;
  });
  EXPECT_EQ(seen, 150);
}

TEST(MetricMaps, OctoMapSaysOfEveryVoxelWhatTheTreeSays) {
  const auto ward = test::makeWard();
  octomap::OcTree tree(0.1);
  fillOctree(ward, tree);
  const auto octoMap = toOctoMap(ward, 0.1);
  double min_x = 0;
  double min_y = 0;
  double min_z = 0;
  double max_x = 0;
  double max_y = 0;
  double max_z = 0;
  tree.getMetricMin(min_x, min_y, min_z);
  tree.getMetricMax(max_x, max_y, max_z);
  int occupied = 0;
  for (double x = min_x - 0.27; x < max_x + 0.3; x += 0.1) {
    for (double y = min_y - 0.27; y < max_y + 0.3; y += 0.1) {
      for (double z = min_z - 0.27; z < max_z + 0.3; z += 0.1) {
        const auto* node = tree.search(x, y, z);
        double occupancy = 0.0;
        const bool isKnown =
            octoMap->getPointOccupancy(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z), occupancy);
        ASSERT_EQ(isKnown, node != nullptr);
        if (!isKnown) continue;
        ASSERT_EQ(occupancy > 0.5, tree.isNodeOccupied(node));
        occupied += occupancy > 0.5 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(occupied, 50);
}

}  // namespace
}  // namespace wardslam::exchange
