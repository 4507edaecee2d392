#include "wardslam/building/room_finder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "wardslam/core/errors.h"

namespace wardslam::building {
namespace {

constexpr unsigned char kFree = mapping::FloorPlan::kFree;
constexpr unsigned char kWall = mapping::FloorPlan::kOccupied;

void fill(mapping::FloorPlan& plan, double x0_m, double y0_m, double x1_m, double y1_m, unsigned char what) {
  const auto cell = [&](double at_m, double from_m) {
    return static_cast<int>(std::lround((at_m - from_m) / plan.resolution_m));
  };
  plan.cells(cv::Range(cell(y0_m, plan.origin_m.y()), cell(y1_m, plan.origin_m.y())),
             cv::Range(cell(x0_m, plan.origin_m.x()), cell(x1_m, plan.origin_m.x())))
      .setTo(what);
}

/// Around 10 m by 9 m, unknown outside: a corridor 10 m × 2 m along y = 0, north of it a ward 5 m × 6 m (x 0 to 5) and
/// a store 4.8 m × 6 m (x 5.2 to 10), walls 0.2 m thick, doors of 1.2 m (x 2 to 3.2) and 0.9 m (x 7 to 7.9).
mapping::FloorPlan makeStorey() {
  mapping::FloorPlan plan;
  plan.resolution_m = 0.05;
  plan.origin_m = {-1.0, -1.0};
  plan.cells = cv::Mat(220, 240, CV_8UC1, cv::Scalar(mapping::FloorPlan::kUnknown));
  fill(plan, -0.2, -0.2, 10.2, 8.4, kWall);
  fill(plan, 0.0, 0.0, 10.0, 2.0, kFree);
  fill(plan, 0.0, 2.2, 5.0, 8.2, kFree);
  fill(plan, 5.2, 2.2, 10.0, 8.2, kFree);
  fill(plan, 2.0, 2.0, 3.2, 2.2, kFree);
  fill(plan, 7.0, 2.0, 7.9, 2.2, kFree);
  return plan;
}

mapping::MapObject makeBed(double x_m, double y_m) {
  mapping::MapObject bed;
  bed.orientedBox.T_map_box.translation() = Eigen::Vector3d(x_m, y_m, 0.5);
  bed.orientedBox.size_m = Eigen::Vector3d(2.0, 1.0, 1.0);
  return bed;
}

TEST(RoomFinder, FindsRoomsAndTheDoorsBetweenThem) {
  const auto rooms = findRooms(makeStorey(), {}, {});
  ASSERT_EQ(rooms.all.size(), 3U);
  const auto* corridor = rooms.at({5.0, 1.0});
  const auto* ward = rooms.at({2.5, 5.0});
  const auto* store = rooms.at({7.5, 5.0});
  ASSERT_TRUE(corridor != nullptr && ward != nullptr && store != nullptr);
  EXPECT_NEAR(corridor->area_m2, 20.0, 0.45);  // the doorways, 0.42 m², may count for either side
  EXPECT_NEAR(ward->area_m2, 30.0, 0.3);
  EXPECT_NEAR(store->area_m2, 28.8, 0.3);
  EXPECT_LT((ward->middle_m - Eigen::Vector2d(2.5, 5.2)).norm(), 0.6);

  ASSERT_EQ(rooms.doors.size(), 2U);
  for (const auto& door : rooms.doors) {
    const bool toWard = door.room == ward->id || door.other == ward->id;
    EXPECT_TRUE(door.room == corridor->id || door.other == corridor->id);
    EXPECT_NEAR(door.width_m, toWard ? 1.2 : 0.9, 0.11);
    EXPECT_LT((door.middle_m() - Eigen::Vector2d(toWard ? 2.6 : 7.45, 2.1)).norm(), 0.2);
  }
}

TEST(RoomFinder, AWidePassageIsNoDoor) {
  auto plan = makeStorey();
  fill(plan, 1.5, 2.0, 4.0, 2.2, kFree);  // 2.5 m between corridor and ward, more than a door has
  const auto rooms = findRooms(plan, {}, {});
  EXPECT_EQ(rooms.all.size(), 2U);
  EXPECT_EQ(rooms.at({5.0, 1.0}), rooms.at({2.5, 5.0}));

  RoomOptions wideDoors;
  wideDoors.widestDoor_m = 3.0;  // and narrower than three quarters of both rooms? the corridor is 2 m wide
  EXPECT_EQ(findRooms(plan, {}, {}, wideDoors).all.size(), 2U);
}

TEST(RoomFinder, AWardWithBedsAlongBothWallsIsOneRoom) {
  auto plan = makeStorey();
  std::vector<mapping::MapObject> beds;
  for (const double y_m : {3.0, 5.2, 7.4}) {
    for (const double x_m : {1.0, 4.0}) {
      beds.push_back(makeBed(x_m, y_m));
      fill(plan, x_m - 1.0, y_m - 0.5, x_m + 1.0, y_m + 0.5, kWall);
    }
  }
  std::vector<const mapping::MapObject*> things;
  for (const auto& bed : beds) things.push_back(&bed);
  const auto rooms = findRooms(plan, things, {});
  EXPECT_EQ(rooms.all.size(), 3U);
  ASSERT_NE(rooms.at({2.5, 5.0}), nullptr);
  EXPECT_NEAR(rooms.at({2.5, 5.0})->area_m2, 30.0, 0.7);  // what stands on it included, and a cell of the walls there
}

TEST(RoomFinder, ADoorLeafOrAPictureDoesNotOpenItsWall) {
  mapping::MapObject leaf = makeBed(2.6, 2.1);
  leaf.orientedBox.size_m = Eigen::Vector3d(5.0, 0.3, 2.0);
  EXPECT_EQ(findRooms(makeStorey(), {&leaf}, {}).all.size(), 3U);
}

TEST(RoomFinder, AHoleInAWallIsNoDoor) {
  auto plan = makeStorey();
  fill(plan, 5.0, 5.0, 5.2, 5.3, kFree);  // 0.3 m between ward and store
  const auto rooms = findRooms(plan, {}, {});
  EXPECT_EQ(rooms.all.size(), 3U);
  EXPECT_EQ(rooms.doors.size(), 2U);
}

TEST(RoomFinder, AThingThatReachesThroughAWallIsNoDoor) {
  auto plan = makeStorey();
  fill(plan, 3.8, 2.2, 4.6, 2.6, kWall);  // it stands in the ward, and its box is too large by 0.4 m
  mapping::MapObject cupboard = makeBed(4.2, 2.2);
  cupboard.orientedBox.size_m = Eigen::Vector3d(0.8, 0.8, 1.0);
  const auto rooms = findRooms(plan, {&cupboard}, {});
  EXPECT_EQ(rooms.all.size(), 3U);
  EXPECT_EQ(rooms.doors.size(), 2U);
}

TEST(RoomFinder, ADoorIsStraightAcrossWhereverTheFloorBehindItEnds) {
  auto plan = makeStorey();
  for (int row = 1; row <= 60; ++row) {  // from the corridor, more of the ward was seen to the right than to the left
    const double y_m = 2.2 + 0.1 * (row - 1);
    fill(plan, 0.0, y_m, std::max(0.05, 2.0 - 0.01 * row), y_m + 0.1, mapping::FloorPlan::kUnknown);
    fill(plan, std::min(4.95, 3.2 + 0.1 * row), y_m, 5.0, y_m + 0.1, mapping::FloorPlan::kUnknown);
  }
  const auto rooms = findRooms(plan, {}, {});
  ASSERT_EQ(rooms.doors.size(), 2U);
  for (const auto& door : rooms.doors) {
    EXPECT_NEAR(door.from_m.y(), door.to_m.y(), 0.06);
    EXPECT_NEAR((door.from_m - door.to_m).norm(), door.width_m, 0.11);
  }
}

TEST(RoomFinder, ATableInTheMiddleIsNoWall) {
  auto plan = makeStorey();
  fill(plan, 2.0, 4.5, 3.0, 6.0, kWall);
  const auto rooms = findRooms(plan, {}, {});
  ASSERT_NE(rooms.at({2.5, 5.0}), nullptr);
  EXPECT_NEAR(rooms.at({2.5, 5.0})->area_m2, 30.0, 0.3);
}

TEST(RoomFinder, TheWidestDoorTellsPassagesFromDoors) {
  auto plan = makeStorey();
  fill(plan, 5.0, 4.0, 5.2, 5.9, kFree);  // 1.9 m between ward and store, in which there is room for 2.4 m around
  EXPECT_EQ(findRooms(plan, {}, {}).all.size(), 2U);
  RoomOptions wideDoors;
  wideDoors.widestDoor_m = 2.1;
  EXPECT_EQ(findRooms(plan, {}, {}, wideDoors).all.size(), 3U);
}

TEST(RoomFinder, ACorridorThatIsALittleNarrowerSomewhereIsOneRoom) {
  auto plan = makeStorey();
  fill(plan, 0.0, 1.5, 10.0, 2.0, kWall);  // leaves 1.5 m of the corridor and shuts both doors
  fill(plan, 4.0, 1.2, 6.0, 1.5, kWall);   // 1.2 m: four fifths of it
  EXPECT_EQ(findRooms(plan, {}, {}).all.size(), 3U);
  fill(plan, 4.0, 0.9, 6.0, 1.2, kWall);  // 0.9 m: three fifths
  EXPECT_EQ(findRooms(plan, {}, {}).all.size(), 4U);
}

TEST(RoomFinder, ACornerBehindACupboardIsNoRoom) {
  auto plan = makeStorey();
  fill(plan, 0.0, 7.0, 1.6, 7.1, kWall);  // 1.6 m × 1.1 m behind it, less than a room has, …
  fill(plan, 1.6, 7.0, 1.7, 7.8, kWall);  // … and a way in of 0.4 m
  const auto rooms = findRooms(plan, {}, {});
  EXPECT_EQ(rooms.all.size(), 3U);
  EXPECT_EQ(rooms.at({0.8, 7.6}), rooms.at({2.5, 5.0}));
}

TEST(RoomFinder, RoomsAreCalledAfterTheZonesThatTheyAre) {
  const std::vector<mapping::Zone> zones = {{"storey", {{-1, -1}, {11, -1}, {11, 9}, {-1, 9}}},
                                            {"ward 3", {{0, 2.1}, {5.1, 2.1}, {5.1, 8.3}, {0, 8.3}}},
                                            {"bedside", {{0, 2.2}, {2, 2.2}, {2, 4}, {0, 4}}}};
  const auto rooms = findRooms(makeStorey(), {}, zones);
  EXPECT_EQ(rooms.at({2.5, 5.0})->name, "ward 3");
  EXPECT_EQ(rooms.at({7.5, 5.0})->name, "room " + std::to_string(rooms.at({7.5, 5.0})->id));
  EXPECT_EQ(rooms.named("ward 3").id, rooms.at({2.5, 5.0})->id);
  try {
    static_cast<void>(rooms.named("ward 4"));
    FAIL();
  } catch (const core::InputError& error) {
    EXPECT_STREQ(error.what(), "no room is called 'ward 4'; did you mean 'ward 3'?");
  }
}

TEST(RoomFinder, KnowsTheRoomOfWhatStandsAtAWall) {
  const auto rooms = findRooms(makeStorey(), {}, {});
  EXPECT_EQ(rooms.at({-0.1, 5.0}), nullptr);
  EXPECT_EQ(rooms.at({-0.1, 5.0}, 0.5), rooms.at({2.5, 5.0}));
  EXPECT_EQ(rooms.at({-0.9, 5.0}, 0.5), nullptr);
  EXPECT_EQ(rooms.at({1e30, 5.0}, 0.5), nullptr);
}

TEST(RoomFinder, OutlinesGoAroundTheRoom) {
  const auto rooms = findRooms(makeStorey(), {}, {});
  for (const auto& room : rooms.all) {
    EXPECT_NEAR(mapping::area_m2({room.name, room.outline_m}), room.area_m2, 0.08 * room.area_m2);
  }
}

TEST(RoomFinder, AMapWithoutAFloorPlanHasNoRooms) {
  const auto rooms = findRooms({}, {}, {});
  EXPECT_TRUE(rooms.all.empty());
  EXPECT_EQ(rooms.at({0.0, 0.0}, 1.0), nullptr);
  EXPECT_THROW(static_cast<void>(rooms.named("ward")), core::InputError);
}

}  // namespace
}  // namespace wardslam::building
