#include "wardslam/fleet/stored_maps.h"

#include "fleet/fleet_test.h"

namespace wardslam::fleet {
namespace {

using StoredMapsTest = FleetTest;

TEST_F(StoredMapsTest, TheNewestIsThatWithTheLastKeyframe) {
  drive(1000.0);
  (void)pushWard({"robot 1", "late", "north", "1"});
  ward_ = test::makeWard();
  (void)pushWard({"robot 2", "early", "north", "1"});
  const auto maps = storedMaps(url_, {"north", "1", "", ""});
  ASSERT_EQ(maps.size(), 2U);
  EXPECT_EQ(maps[0].name, "late");
  EXPECT_EQ(maps[0].lastStamp_s, 2000.0);
  EXPECT_EQ(maps[1].robot, "robot 2");
}

TEST_F(StoredMapsTest, PulledIsWhatWasPushed) {
  (void)pushWard();
  const auto pulled = folder_.path() / "pulled.wardmap";
  (void)pullNewestMap(url_, {}, pulled);
  EXPECT_EQ(test::readText(pulled), test::readText(file_));
}

TEST_F(StoredMapsTest, WhatTheDatabaseSpoiledIsNoMap) {
  (void)pushWard();
  (void)sql("UPDATE chunks SET bytes = set_byte(bytes, 5000, (get_byte(bytes, 5000) + 1) % 256)");
  const auto pulled = folder_.path() / "pulled.wardmap";
  EXPECT_THAT(test::complaintOf([&] { return pullNewestMap(url_, {}, pulled).id; }),
              testing::HasSubstr("is not what was pushed"));
  EXPECT_FALSE(std::filesystem::exists(pulled));
}

TEST_F(StoredMapsTest, WhatIsReadIsToTheBitWhatTheFileHolds) {
  ward_.objects[5].centroid_m = {0.1, 1.0 / 3.0, 1e-7};
  ward_.objects[5].box_m = {Eigen::Vector3d(0.1, 0.2, 0.3), Eigen::Vector3d(0.7, 100000.1, 1.0 / 3.0)};
  ward_.zones[0].polygon_m[0] = {-1.0 / 3.0, -0.1};
  ward_.zones[0].type = mapping::ZoneType::OneWay;
  ward_.zones[0].direction_rad = -1.0 / 3.0;
  ward_.zones[1].type = mapping::ZoneType::Action;
  ward_.zones[1].actions = {{"ring"}, {}, {"hush"}};
  (void)pushWard();
  const auto read = readNewestMap(url_, {});
  EXPECT_EQ(read.objects.at(5).centroid_m, ward_.objects[5].centroid_m);
  EXPECT_EQ(read.objects.at(5).box_m.min(), ward_.objects[5].box_m.min());
  EXPECT_EQ(read.objects.at(5).box_m.max(), ward_.objects[5].box_m.max());
  EXPECT_EQ(read.zones[0].polygon_m, ward_.zones[0].polygon_m);
  EXPECT_EQ(read.zones[0].type, mapping::ZoneType::OneWay);
  EXPECT_EQ(read.zones[0].direction_rad, -1.0 / 3.0);
  EXPECT_EQ(read.zones[1].actions.entry, ward_.zones[1].actions.entry);
  EXPECT_EQ(read.zones[1].actions.exit, ward_.zones[1].actions.exit);
  EXPECT_EQ(cv::norm(read.floorPlan.cells, ward_.floorPlan.cells, cv::NORM_INF), 0.0);
}

}  // namespace
}  // namespace wardslam::fleet
