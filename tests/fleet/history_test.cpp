#include "wardslam/fleet/history.h"

#include "fleet/fleet_test.h"

namespace wardslam::fleet {
namespace {

/// The bed (5) stood in the ward at (5.5, 3) from 900 to 999, and is seen at (0, 3), in the clean zone, at 1999; then
/// the bag (3), in the clean zone until 999, is found gone by 3000.
class HistoryTest : public FleetTest {
 protected:
  void SetUp() override {
    FleetTest::SetUp();
    if (IsSkipped()) return;
    (void)pushWard();
    drive(1000.0);
    auto bed = test::makeObject(5, test::kBed, {0.0, 3.0, 0.4}, {1.0, 2.0, 0.8});
    bed.firstSeen_s = 900.0;
    bed.lastSeen_s = 1999.0;
    bed.state = mapping::ObjectState::Moved;
    bed.zone = "clean zone";
    ward_.objects[5] = bed;
    (void)pushWard();
    drive(1000.0);
    ward_.objects[3].state = mapping::ObjectState::Gone;
    (void)pushWard();
  }

  [[nodiscard]] Whereabouts bedAt(double at_s) const {
    const auto found = whereWas(url_, {}, "bed", 5, at_s);
    return found.size() == 1 ? found.front() : Whereabouts();
  }
};

TEST_F(HistoryTest, WhereAThingWas) {
  const auto before = bedAt(950.0);
  EXPECT_EQ(before.place_m, Eigen::Vector3d(5.5, 3.0, 0.4));
  EXPECT_EQ(before.box_m.min(), Eigen::Vector3d(5.0, 2.0, 0.0));
  EXPECT_EQ(before.zone, "ward");
  EXPECT_EQ(before.since_s, 900.0);
  EXPECT_EQ(before.until_s, 999.0);
  EXPECT_EQ(before.ended, "moved");
  EXPECT_EQ(before.ended_s, 1999.0);
  EXPECT_EQ(before.robot, "robot 1");
  EXPECT_EQ(bedAt(1500.0).zone, "ward");  // where it was last seen
  EXPECT_EQ(bedAt(1999.0).zone, "clean zone");
  EXPECT_EQ(bedAt(9999.0).place_m, Eigen::Vector3d(0.0, 3.0, 0.4));
  EXPECT_TRUE(whereWas(url_, {}, "bed", 5, 899.0).empty());
  EXPECT_TRUE(whereWas(url_, {}, "chair", 5, 950.0).empty());
  EXPECT_TRUE(whereWas(url_, {"north", "2", "", ""}, "bed", 5, 950.0).empty());
}

TEST_F(HistoryTest, WhatLeftAZone) {
  // The clean zone lies in the ward: the bed did not leave that.
  const auto left = whatLeft(url_, {}, "clean zone", 1500.0);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].object, 3U);
  EXPECT_EQ(left[0].ended, "gone");
  EXPECT_EQ(left[0].ended_s, 3000.0);
  EXPECT_FALSE(left[0].next);
  EXPECT_TRUE(whatLeft(url_, {}, "clean zone", 3001.0).empty());
  for (const auto& one : whatLeft(url_, {}, "ward", 0.0)) EXPECT_NE(one.object, 5U);
}

TEST_F(HistoryTest, WhatLeftARoom) {
  // The ward's wall makes two rooms; the one with x > 3 has no zone of its own.
  EXPECT_EQ(bedAt(950.0).room, "room 1");
  EXPECT_EQ(bedAt(2000.0).room, "clean zone");
  const auto left = whatLeft(url_, {}, "room 1", 1500.0);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].object, 5U);
  EXPECT_EQ(left[0].next, "clean zone");
  EXPECT_TRUE(whatLeft(url_, {}, "room 1", 2000.0).empty());
  EXPECT_EQ(test::complaintOf([&] { return whatLeft(url_, {}, "room 11", 0.0).size(); }),
            "no zone or room is called 'room 11'; did you mean 'room 1'?");
}

TEST_F(HistoryTest, AThingAtAWallStandsInTheRoomBeforeIt) {
  const auto roomAt = [&](const std::string& x_m) {
    return sql("SELECT room_at(1, ST_MakePoint(" + x_m + ", 2, 0.5))");
  };
  EXPECT_EQ(roomAt("2.98"), "clean zone");
  EXPECT_EQ(roomAt("3.05"), "clean zone");
  EXPECT_EQ(roomAt("3.15"), "room 1");
  EXPECT_EQ(roomAt("7.4"), "room 1");
  EXPECT_EQ(roomAt("7.6"), "");
}

TEST_F(HistoryTest, WhatStoodNearAPlace) {
  const auto numbers = [&](double at_s) {
    std::vector<mapping::ObjectId> found;
    for (const auto& one : whatStood(url_, {}, {5.5, 3.0, 1.4}, 1.0, at_s)) found.push_back(one.object);
    return found;
  };
  EXPECT_EQ(numbers(950.0), std::vector<mapping::ObjectId>{5});
  EXPECT_TRUE(numbers(2500.0).empty());
  EXPECT_TRUE(whatStood(url_, {}, {5.5, 3.0, 1.41}, 1.0, 950.0).empty());
}

TEST_F(HistoryTest, ThePlaceIsFoundByTheIndexOfAllThreeAxes) {
  const std::string plan =
      sql("SET enable_seqscan = off; EXPLAIN SELECT * FROM sightings WHERE map = 1 AND ST_3DDWithin(place, "
          "ST_MakePoint(1, 2, 3), 1)");
  EXPECT_THAT(plan, testing::HasSubstr("sightings_by_place"));
  EXPECT_THAT(plan, testing::HasSubstr("place &&& "));
}

TEST_F(HistoryTest, AMapThatGoesOnKnowsTheSameThings) {
  drive(1000.0);
  ward_.objects[5].centroid_m.x() = 2.0;
  ward_.objects[5].lastSeen_s = 3999.0;
  (void)pushWard({"robot 2", "ward", "north", "1"});
  const auto found = whereWas(url_, {"", "", "robot 1", ""}, "bed", 5, 4000.0);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].robot, "robot 2");
  EXPECT_EQ(found[0].until_s, 3999.0);
  EXPECT_EQ(found[1].robot, "robot 1");
}

}  // namespace
}  // namespace wardslam::fleet
