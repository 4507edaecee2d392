#include "wardslam/exchange/simple_map.h"

#include <gmock/gmock.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/COctoMap.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>

#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/exchange/map_export.h"
#include "wardslam/mapping/cloud_in_map.h"

namespace wardslam::exchange {
namespace {

/// A camera at (0, 1.025), 1 m high, looks along x at the wall of makeFloorPlan(), whose face is at x = 3.
mapping::SemanticMap makeMapBeforeAWall() {
  mapping::SemanticMap map;
  map.floorPlan = test::makeFloorPlan();
  auto& keyframe = map.keyframes[1];
  keyframe.stamp_s = 1000.0;
  keyframe.T_map_cam.translation() = Eigen::Vector3d(0, 1.025, 1);
  keyframe.T_map_cam.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  mapping::SemanticPoint point;
  point.p_cam_m = {0.5F, 0.25F, 3.0F};  // right, down, ahead
  map.cloud[1].points.push_back(point);
  return map;
}

TEST(SimpleMap, MakesTheCloudWhereTheMapHasIt) {
  auto ward = test::makeWard();
  ward.floorPlan = {};  // no scans in the plane, whose ends are points too
  mrpt::maps::CSimplePointsMap points;
  points.insertionOptions.minDistBetweenLaserPoints = 0.0F;
  points.loadFromSimpleMap(toSimpleMap(ward));
  std::size_t i = 0;
  mapping::forEachCloudPoint(ward, [&](const Eigen::Vector3f& p_m, const mapping::SemanticPoint&) {
    float x = 0;
    float y = 0;
    float z = 0;
    ASSERT_LT(i, points.size());
    points.getPoint(i++, x, y, z);
    EXPECT_LT((Eigen::Vector3f(x, y, z) - p_m).norm(), 1e-5F);
  });
  EXPECT_EQ(i, points.size());
}

TEST(SimpleMap, PutsAPointWhereACameraThatLooksAlongXSawIt) {
  auto map = makeMapBeforeAWall();
  map.floorPlan = {};  // no scans in the plane, whose ends are points too
  const auto simple = toSimpleMap(map);
  ASSERT_EQ(simple.size(), 1U);
  mrpt::maps::CSimplePointsMap points;
  points.loadFromSimpleMap(simple);
  ASSERT_EQ(points.size(), 1U);
  float x = 0;
  float y = 0;
  float z = 0;
  points.getPoint(0, x, y, z);
  EXPECT_NEAR(x, 3.0, 1e-5);
  EXPECT_NEAR(y, 1.025 - 0.5, 1e-5);
  EXPECT_NEAR(z, 1.0 - 0.25, 1e-5);
}

TEST(SimpleMap, MakesAGridOfTheFloorPlan) {
  mrpt::maps::COccupancyGridMap2D grid(-1.0F, 7.0F, -1.0F, 5.0F, 0.05F);
  grid.loadFromSimpleMap(toSimpleMap(makeMapBeforeAWall()));
  EXPECT_GT(grid.getPos(1.5F, 1.03F), 0.5F);         // free on the way
  EXPECT_LT(grid.getPos(3.02F, 1.03F), 0.5F);        // the wall
  EXPECT_FLOAT_EQ(grid.getPos(3.5F, 1.03F), 0.5F);   // behind it
  EXPECT_FLOAT_EQ(grid.getPos(-0.5F, 1.03F), 0.5F);  // free floor, but nothing stands behind it
}

/// A camera on a robot looks down a little, and no mount is true.
TEST(SimpleMap, MakesGridAndPointsHoweverTheCameraIsTilted) {
  auto map = makeMapBeforeAWall();
  auto& T_map_cam = map.keyframes[1].T_map_cam;
  auto& point = map.cloud[1].points[0];
  point.p_cam_m = {0.52F, 0.28F, 3.02F};  // within a cell
  const Eigen::Vector3f p_map_m = T_map_cam.cast<float>() * point.p_cam_m;
  T_map_cam.rotate(Eigen::AngleAxisd(0.35, Eigen::Vector3d(-0.9, 0.0, 0.4359).normalized()));  // down, and rolled
  point.p_cam_m = T_map_cam.cast<float>().inverse() * p_map_m;
  const auto simple = toSimpleMap(map);
  mrpt::maps::COccupancyGridMap2D grid(-1.0F, 7.0F, -1.0F, 5.0F, 0.05F);
  grid.loadFromSimpleMap(simple);
  EXPECT_GT(grid.getPos(1.5F, 1.03F), 0.5F);        // free on the way
  EXPECT_LT(grid.getPos(3.02F, 1.03F), 0.5F);       // the wall
  EXPECT_FLOAT_EQ(grid.getPos(3.5F, 1.03F), 0.5F);  // behind it
  mrpt::maps::COctoMap octoMap(0.05);
  map.floorPlan = {};  // no ends of scans
  octoMap.loadFromSimpleMap(toSimpleMap(map));
  double occupancy = 0.0;
  ASSERT_TRUE(octoMap.getPointOccupancy(p_map_m.x(), p_map_m.y(), p_map_m.z(), occupancy));
  EXPECT_GT(occupancy, 0.5);
}

/// MRPT's COctoMap does not ask where on the robot a 3D scan was taken.
TEST(SimpleMap, MakesAnOctoMapOfTheCloudWhereverTheCameraIs) {
  auto ward = test::makeWard();
  ward.floorPlan = {};
  mrpt::maps::COctoMap octoMap(0.05);
  octoMap.loadFromSimpleMap(toSimpleMap(ward));
  int known = 0;
  mapping::forEachCloudPoint(ward, [&](const Eigen::Vector3f& p_m, const mapping::SemanticPoint&) {
    double occupancy = 0.0;
    known += octoMap.getPointOccupancy(p_m.x(), p_m.y(), p_m.z(), occupancy) ? 1 : 0;
  });
  EXPECT_EQ(known, 150);
}

TEST(SimpleMap, IsAFileOfMrpts) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "ward.simplemap";
  exportSimpleMap(test::makeWard(), file);
  mrpt::maps::CSimpleMap back;
  ASSERT_TRUE(back.loadFromFile(file.string()));
  EXPECT_EQ(back.size(), 3U);
}

}  // namespace
}  // namespace wardslam::exchange
