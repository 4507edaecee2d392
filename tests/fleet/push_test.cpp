#include "wardslam/fleet/push.h"

#include <atomic>
#include <chrono>
#include <thread>

#include "fleet/fleet_test.h"

namespace wardslam::fleet {
namespace {

using testing::HasSubstr;
using Outcome = PushReport::Outcome;

using PushTest = FleetTest;

TEST_F(PushTest, WritesWhatTheMapHolds) {
  const auto report = pushWard();
  EXPECT_EQ(report.outcome, Outcome::Pushed);
  EXPECT_EQ(report.keyframes, 3U);
  EXPECT_EQ(report.objects, 7U);
  EXPECT_EQ(report.changes, 7U);
  EXPECT_EQ(report.file_bytes, std::filesystem::file_size(file_));
  EXPECT_EQ(sql("SELECT ST_AsText(place), ST_AsText(box), zone FROM objects WHERE number = 5"),
            "POINT Z (5.5 3 0.4)|MULTIPOINT Z ((5 2 0),(6 4 0.8))|ward");
  EXPECT_EQ(sql("SELECT ST_AsText(way), first_s, last_s FROM runs"),
            "LINESTRING ZM (0.5 1 1.2 998,1 1 1.2 999,1.5 1 1.2 1000)|998|1000");
  EXPECT_EQ(sql("SELECT x_m, y_m, z_m, qx, qy, qz, qw FROM maps"), "0|0|0|0|0|0|1");
}

TEST_F(PushTest, WritesTheRooms) {
  (void)pushWard();
  // 3.8 m by 5.9 m, and 4 m by 5.9 m, each less half a cell all around.
  EXPECT_EQ(sql("SELECT name, round(ST_XMin(area)::numeric, 1), round(ST_Area(area)), ST_IsValid(area) FROM rooms "
                "ORDER BY number"),
            "room 1|3.2|22|t\nclean zone|-1.0|23|t");
  drive(1.0);
  ward_.floorPlan.cells.colRange(80, 84).setTo(mapping::FloorPlan::kFree);  // no wall any more
  (void)pushWard();
  EXPECT_EQ(sql("SELECT count(*), min(name) FROM rooms"), "1|ward");
}

TEST_F(PushTest, TwiceIsAsOnce) {
  (void)pushWard();
  const std::string once = counts();
  const auto again = push(url_, {"robot 1", "ward", "north", "1"}, file_);
  EXPECT_EQ(again.outcome, Outcome::WasThere);
  EXPECT_EQ(again.file_bytes, 0U);
  EXPECT_EQ(counts(), once);
}

TEST_F(PushTest, SendsWhatIsNew) {
  (void)pushWard();
  drive(1.0);
  ward_.objects[2].lastSeen_s += 1.0;
  const auto report = pushWard();
  EXPECT_EQ(report.keyframes, 1U);
  EXPECT_EQ(report.objects, 1U);
  EXPECT_EQ(report.changes, 0U);
  EXPECT_EQ(count("keyframes"), 4);
  EXPECT_EQ(count("sightings"), 7);
  EXPECT_EQ(sql("SELECT since_s, until_s FROM sightings WHERE object = 2"), "900|1000");
}

TEST_F(PushTest, AnOlderStateIsNotTaken) {
  const auto before = ward_;
  drive(1.0);
  (void)pushWard();
  ward_ = before;
  EXPECT_EQ(pushWard().outcome, Outcome::NewerIsThere);
  EXPECT_EQ(count("keyframes"), 4);
}

TEST_F(PushTest, AnotherMapNeedsAnotherName) {
  (void)pushWard();
  for (auto& [id, keyframe] : ward_.keyframes) keyframe.stamp_s += 5000.0;
  EXPECT_THAT(test::complaintOf([&] { return pushWard().objects; }), HasSubstr("give this one a --name of its own"));
  EXPECT_EQ(pushWard({"robot 1", "tuesday", "north", "1"}).keyframes, 3U);
  EXPECT_EQ(sql("SELECT count(x_m) FROM maps"), "1");  // how the second lies nobody said
}

TEST_F(PushTest, WhatTheMapNoLongerHasIsNotAskedFor) {
  (void)pushWard();
  drive(1.0);
  ward_.objects.erase(2);
  ward_.keyframes.erase(1);
  ward_.cloud.erase(1);
  (void)pushWard();
  EXPECT_EQ(sql("SELECT in_map FROM objects WHERE number = 2"), "f");
  EXPECT_EQ(count("sightings"), 7);
  EXPECT_EQ(count("keyframes"), 3);
}

constexpr int kRobots = 10;

MapIdentity mapOf(int robot) { return {"robot " + std::to_string(robot), "ward", "north", "1"}; }

TEST_F(PushTest, TenRobotsAtOnceLoseAndDoubleNothing) {
  writeWard();
  atOnce(kRobots, [&](int robot) { EXPECT_EQ(push(url_, mapOf(robot), file_).objects, 7U); });
  EXPECT_EQ(sql("SELECT count(*), count(DISTINCT robot) FROM maps"), "10|10");
  EXPECT_EQ(count("storeys"), 1);
  for (const auto& [table, rows] : {std::pair("keyframes", 30), std::pair("objects", 70), std::pair("sightings", 70)}) {
    EXPECT_EQ(count(table), rows) << table;
  }
}

TEST_F(PushTest, OneMapPushedTenTimesAtOnceIsThereOnce) {
  writeWard();
  std::atomic<int> pushed = 0;
  atOnce(kRobots, [&](int) {
    if (push(url_, mapOf(1), file_).outcome == Outcome::Pushed) ++pushed;
  });
  EXPECT_EQ(pushed, 1);
  EXPECT_EQ(count("maps"), 1);
  EXPECT_EQ(count("sightings"), 7);
  EXPECT_EQ(count("pushes"), 1);
}

TEST_F(PushTest, AServerThatIsKilledAgainAndAgainLosesAndDoublesNothing) {
  writeWard();
  std::atomic<int> brokeOff = 0;
  std::atomic<int> told = 0;
  std::atomic<bool> isOver = false;
  std::thread killer([&] {
    for (int kills = 0; kills < 4 || (brokeOff == 0 && kills < 12); ++kills) {
      std::this_thread::sleep_for(std::chrono::milliseconds(60));
      server().kill();
      server().start();
    }
    isOver = true;
  });
  atOnce(kRobots, [&](int robot) {
    PushOptions options;
    options.note = [&](const std::string&) { ++brokeOff; };
    for (int map = 1; map <= 500 && !isOver; ++map) {
      const MapIdentity identity{mapOf(robot).robot, "ward " + std::to_string(map), "north", "1"};
      for (bool isIn = false; !isIn;) {  // as a robot does: again, until the database has it
        try {
          (void)push(url_, identity, file_, options);
          isIn = true;
          ++told;
        } catch (const CannotConnect&) {
          std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
      }
    }
  });
  killer.join();
  EXPECT_GT(brokeOff, 0);
  const int maps = count("maps");
  EXPECT_GE(maps, 10);
  EXPECT_EQ(maps, told);
  EXPECT_EQ(count("pushes"), maps);
  EXPECT_EQ(count("keyframes"), 3 * maps);
  EXPECT_EQ(count("objects"), 7 * maps);
  EXPECT_EQ(count("sightings"), 7 * maps);
  EXPECT_EQ(count("changes"), 7 * maps);
  EXPECT_EQ(sql("SELECT count(*) FROM maps WHERE NOT EXISTS (SELECT FROM file_chunks WHERE map = maps.id)"), "0");
}

}  // namespace
}  // namespace wardslam::fleet
