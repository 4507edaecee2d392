#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "integration/cli_test_support.h"
#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

class MapCommandTest : public testing::Test {
 protected:
  MapCommandTest() { storage::MapFile::create(path_).write(storage::everythingOf(makeWard())); }

  CommandResult map(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "map");
    arguments.insert(arguments.begin() + 2, path_);
    return runProgram("wardslam", arguments);
  }
  json mapJson(std::vector<std::string> arguments) const {
    arguments.emplace_back("--json");
    const auto result = map(arguments);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return json::parse(result.out);
  }
  std::vector<int> objectIds(const std::vector<std::string>& filter) const {
    std::vector<std::string> arguments = {"objects"};
    arguments.insert(arguments.end(), filter.begin(), filter.end());
    std::vector<int> ids;
    const json found = mapJson(arguments);
    for (const auto& object : found["objects"]) ids.push_back(object["id"]);
    return ids;
  }

  TemporaryFolder folder_;
  std::string path_ = (folder_.path() / "ward.wardmap").string();
};

TEST_F(MapCommandTest, ObjectsAsJsonHaveExactlyThePromisedFields) {
  auto map = makeWard();
  map.objects = {{3, makeObject(3, kBackpack, {2.0, 2.5, 0.75}, {0.5, 0.25, 0.5})}};  // binary fractions
  map.objects[3].zone = "clean zone";
  storage::MapFile::create(path_).write(storage::everythingOf(map));
  EXPECT_EQ(mapJson({"objects"}), json::parse(R"({"objects": [{"id": 3, "class_id": 25, "class_name": "backpack",
      "centroid": [2.0, 2.5, 0.75], "box_min": [1.75, 2.375, 0.5], "box_max": [2.25, 2.625, 1.0],
      "probability": 0.75, "views": 5, "zone": "clean zone", "state": "static"}]})"));
}

TEST_F(MapCommandTest, ObjectsCanBeChosen) {
  EXPECT_THAT(objectIds({}), ElementsAre(1, 2, 3, 4, 5, 7));
  EXPECT_THAT(objectIds({"--state", "any"}), ElementsAre(1, 2, 3, 4, 5, 6, 7));
  EXPECT_THAT(objectIds({"--state", "gone"}), ElementsAre(6));
  EXPECT_THAT(objectIds({"--class", "chair", "--zone", "clean zone", "--free"}), ElementsAre(1));
  EXPECT_THAT(objectIds({"--box", "0.2", "-1", "0", "3.8", "1", "1"}), ElementsAre(1, 4));
  EXPECT_THAT(objectIds({"--unseen-for", "30"}), ElementsAre(7));
  EXPECT_THAT(objectIds({"--seen-within", "30", "--class", "chair"}), ElementsAre(1, 2, 4));
}

TEST_F(MapCommandTest, ObjectsAsTable) {
  const auto result = map({"objects", "--class", "bed"});
  EXPECT_EQ(result.out,
            "id  class  probability  centroid [m]    size [m]        views  zone  state\n"
            " 5  bed           0.75  5.50 3.00 0.40  1.00 2.00 0.80      5  ward  static\n");
}

TEST_F(MapCommandTest, NearestOfAClass) {
  const auto straight = mapJson({"nearest", "chair", "-0.9", "-0.1"});
  EXPECT_EQ(straight["object"]["id"], 1);
  EXPECT_NEAR(straight["distance"].get<double>(), std::hypot(0.9, 0.1), 1e-9);
  EXPECT_EQ(mapJson({"nearest", "chair", "3", "0.4"})["object"]["id"], 4);
  EXPECT_EQ(mapJson({"nearest", "chair", "2.5", "0.4", "--floor"})["object"]["id"], 2);
  EXPECT_TRUE(mapJson({"nearest", "car", "0", "0"})["object"].is_null());
  EXPECT_THAT(map({"nearest", "chair", "0", "0", "1.45"}).out, HasSubstr("1.00 m away\n"));
  EXPECT_EQ(map({"nearest", "car", "0", "0"}).out, "none\n");
}

TEST_F(MapCommandTest, WhatIsAtAPoint) {
  const auto place = mapJson({"at", "2", "2", "0.6"});
  EXPECT_EQ(place["objects"][0]["id"], 3);
  EXPECT_EQ(place["zones"], json({"clean zone", "ward"}));
  EXPECT_EQ(place["floor"], "free");
  EXPECT_EQ(map({"at", "3.1", "0", "0"}).out, "floor: occupied\nzones: ward\nobjects: none\n");
}

TEST_F(MapCommandTest, ZonesAndWhatStandsInThem) {
  const auto zones = mapJson({"zones"})["zones"];
  ASSERT_EQ(zones.size(), 2U);
  EXPECT_EQ(zones[1]["name"], "clean zone");
  EXPECT_NEAR(zones[1]["area_m2"].get<double>(), 24.0, 1e-6);
  EXPECT_EQ(zones[1]["objects"], 3);
  EXPECT_EQ(zones[1]["keyframes"], 3);
  EXPECT_EQ(zones[1]["polygon"].size(), 4U);
}

TEST_F(MapCommandTest, RoomsOnBothSidesOfTheWall) {
  const json found = mapJson({"rooms"});
  ASSERT_EQ(found["rooms"].size(), 2U);
  ASSERT_EQ(found["doors"].size(), 1U);
  EXPECT_NEAR(found["doors"][0]["width_m"].get<double>(), 0.9, 0.11);
  const auto& zoned = found["rooms"][found["rooms"][0]["name"] == "clean zone" ? 0 : 1];
  EXPECT_EQ(zoned["name"], "clean zone");
  EXPECT_NEAR(zoned["area_m2"].get<double>(), 4.0 * 5.9, 0.4);
  EXPECT_EQ(zoned["objects"], 3);
  EXPECT_EQ(zoned["object_ids"], json({1, 2, 3}));
  EXPECT_EQ(zoned["keyframe_ids"], json({1, 2, 3}));
  EXPECT_THAT(objectIds({"--room", "clean zone"}), ElementsAre(1, 2, 3));
  const auto unknown = map({"objects", "--room", "clean zones"});
  EXPECT_EQ(unknown.exitCode, 1);
  EXPECT_THAT(unknown.err, HasSubstr("no room is called 'clean zones'; did you mean 'clean zone'?"));
}

TEST_F(MapCommandTest, InfoTellsHowMuchTheMapHolds) {
  const auto info = mapJson({"info"});
  EXPECT_EQ(info["keyframes"], 3);
  EXPECT_EQ(info["objects"], 7);
  EXPECT_EQ(info["cloud_points"], 150);
  EXPECT_NEAR(info["floor_free_m2"].get<double>(), 48.0 - 0.2 * 5.0 - 0.1 * 8.0, 1e-6);
  EXPECT_THAT(map({"info"}).out, HasSubstr("1970-01-01 00:16:40 UTC"));
}

TEST_F(MapCommandTest, TheFloorPlanOfAKilledRunIsMadeUpFor) {
  auto ward = makeWard();
  ward.floorPlan = {};
  ward.cloud.clear();
  mapping::MappedKeyframe keyframe;  // looks along x, and saw 3 m of free floor
  keyframe.T_map_cam.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  for (int i = -100; i <= 100; ++i) keyframe.freeFan_cam_m.emplace_back(0.01F * static_cast<float>(i), 0.0F, 3.0F);
  ward.keyframes = {{1, keyframe}};
  storage::MapFile::create(path_).write(storage::everythingOf(ward));
  EXPECT_NEAR(mapJson({"info"})["floor_free_m2"].get<double>(), 3.0, 0.3);  // 3 m far, 2 m wide, half of it
}

TEST_F(MapCommandTest, DiffTellsWhatMovedIsGoneAndIsNew) {
  auto later = makeWard();
  later.objects[1].centroid_m.x() += 1.0;
  later.objects.erase(3);
  later.objects[8] = makeObject(8, kBed, {0, 4, 0.4}, {1, 2, 0.8});
  const std::string other = (folder_.path() / "later.wardmap").string();
  storage::MapFile::create(other).write(storage::everythingOf(later));
  const auto diff = mapJson({"diff", other});
  EXPECT_EQ(diff["moved"].size(), 1U);
  EXPECT_EQ(diff["moved"][0]["after"]["id"], 1);
  EXPECT_EQ(diff["gone"][0]["class_name"], "backpack");
  EXPECT_EQ(diff["new"][0]["id"], 8);
  EXPECT_EQ(diff["unchanged"], 4);
  EXPECT_THAT(map({"diff", other}).out, HasSubstr("4 unchanged\n"));
}

TEST_F(MapCommandTest, CheckIsSatisfiedWithASoundFileAndFailsForADamagedOne) {
  EXPECT_EQ(map({"check"}).exitCode, 0);
  std::filesystem::resize_file(path_, std::filesystem::file_size(path_) - 4096);
  const auto damaged = map({"check"});
  EXPECT_EQ(damaged.exitCode, 1);
  EXPECT_THAT(damaged.err, HasSubstr("ward.wardmap: is damaged"));
}

TEST_F(MapCommandTest, NamesWhatWasProbablyMeant) {
  EXPECT_THAT(map({"objects", "--class", "chairr"}).err, HasSubstr("did you mean 'chair'"));
  EXPECT_THAT(map({"objects", "--zone", "clear zone"}).err, HasSubstr("did you mean 'clean zone'"));
  EXPECT_EQ(map({"objects", "--class", "chairr"}).exitCode, 1);
  EXPECT_EQ(map({"nearest", "chair"}).exitCode, 2);
  EXPECT_EQ(runProgram("wardslam", {"map"}).exitCode, 2);
}

}  // namespace
}  // namespace wardslam::test
