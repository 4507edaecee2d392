#include "wardslam/evaluation/room_evaluation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wardslam::evaluation {
namespace {

using Polygon = std::vector<Eigen::Vector2d>;

Polygon rectangle(double x0_m, double y0_m, double x1_m, double y1_m) {
  return {{x0_m, y0_m}, {x1_m, y0_m}, {x1_m, y1_m}, {x0_m, y1_m}};
}

/// Two rooms of 4 x 4 m and, along both, a corridor of 8 x 2 m; from room A a door is open to it, that of B is closed.
/// The map's cells are of a metre, all free; what room they are of is up to the test.
class RoomEvaluationTest : public testing::Test {
 protected:
  RoomEvaluationTest() {
    truth_.rooms = {
        {"a", "A", rectangle(0, 0, 4, 4)}, {"b", "B", rectangle(4, 0, 8, 4)}, {"c", "C", rectangle(0, 4, 8, 6)}};
    truth_.doors = {{"a", "c", {1.5, 4}, {2.5, 4}, true, M_PI / 2}, {"b", "c", {5.5, 4}, {6.5, 4}, true, 0.0}};
    plan_.resolution_m = 1.0;
    plan_.cells = cv::Mat(6, 8, CV_8UC1, cv::Scalar(mapping::FloorPlan::kFree));
    found_.ids = cv::Mat(6, 8, CV_32SC1, cv::Scalar(0));
  }

  void addRoom(int column, int row, int columns, int rows) {
    building::Room& room = found_.all.emplace_back();
    room.id = static_cast<int>(found_.all.size());
    room.name = "room " + std::to_string(room.id);
    found_.ids(cv::Rect(column, row, columns, rows)) = room.id;
  }

  void addDoor(const Eigen::Vector2d& middle_m) {
    const Eigen::Vector2d half_m(0.5, 0.0);
    found_.doors.push_back({1, 2, middle_m - half_m, middle_m + half_m, 1.0});
  }

  [[nodiscard]] RoomEvaluation evaluate(const Eigen::Isometry2d& T_truth_map = Eigen::Isometry2d::Identity()) const {
    return evaluateRooms(truth_, plan_, found_, T_truth_map);
  }

  TrueBuilding truth_;
  mapping::FloorPlan plan_;
  building::Rooms found_;
};

TEST_F(RoomEvaluationTest, ARoomInTwoIsASplit) {
  addRoom(0, 0, 4, 4);
  addRoom(4, 0, 2, 4);
  addRoom(6, 0, 2, 4);
  addRoom(0, 4, 7, 2);  // of the corridor the last metre is of no room
  const auto result = evaluate();
  ASSERT_EQ(result.rooms.size(), 3U);
  EXPECT_EQ(result.rooms[0].name, "A");
  EXPECT_EQ(result.rooms[0].found, "room 1");
  EXPECT_DOUBLE_EQ(result.rooms[0].overlap, 1.0);
  EXPECT_DOUBLE_EQ(result.rooms[1].overlap, 8.0 / 16.0);
  EXPECT_FALSE(result.rooms[1].isFound) << "half of it might be any of two";
  EXPECT_DOUBLE_EQ(result.rooms[2].overlap, 14.0 / 16.0);
  EXPECT_DOUBLE_EQ(result.rooms[2].seen_m2, 16.0);
  EXPECT_EQ(result.told, 4U);
  EXPECT_EQ(result.found, 2U);
  EXPECT_DOUBLE_EQ(result.meanOverlap(), (1.0 + 14.0 / 16.0) / 2.0);
  EXPECT_EQ(result.splits, 1U);
  EXPECT_EQ(result.joins, 0U);
}

TEST_F(RoomEvaluationTest, TwoRoomsInOneAreAJoin) {
  addRoom(0, 0, 8, 4);
  addRoom(0, 4, 8, 2);
  const auto result = evaluate();
  EXPECT_EQ(result.found, 1U);
  EXPECT_EQ(result.splits, 0U);
  EXPECT_EQ(result.joins, 1U);
}

TEST_F(RoomEvaluationTest, RoomsOpenToEachOtherAreOne) {
  truth_.doors.push_back({"a", "b", {4, 0.5}, {4, 3.5}, false, 0.0});
  addRoom(0, 0, 8, 4);
  addRoom(0, 4, 8, 2);
  const auto result = evaluate();
  ASSERT_EQ(result.rooms.size(), 2U);
  EXPECT_EQ(result.rooms[0].name, "A, B");
  EXPECT_EQ(result.found, 2U);
  EXPECT_EQ(result.joins, 0U);
  truth_.doors.back().to_m.y() = 2.0;
  EXPECT_EQ(evaluate().rooms.size(), 3U) << "an opening of 1.5 m is a door";
}

TEST_F(RoomEvaluationTest, WhatWasNotSeenDoesNotCount) {
  plan_.cells(cv::Rect(4, 0, 4, 4)) = mapping::FloorPlan::kUnknown;
  plan_.cells.at<unsigned char>(0, 4) = mapping::FloorPlan::kFree;  // 1 m2 of room B
  truth_.doors[1].open_rad = M_PI / 2;
  addRoom(0, 0, 4, 4);
  addRoom(0, 4, 8, 2);
  const auto result = evaluate();
  EXPECT_EQ(result.rooms.size(), 2U);
  EXPECT_EQ(result.found, 2U);
  EXPECT_EQ(result.doors, 1U) << "that of B leads to where nobody was";
}

TEST_F(RoomEvaluationTest, DoorsAreFoundOneForOne) {
  addRoom(0, 0, 4, 4);
  addRoom(4, 0, 4, 4);
  addRoom(0, 4, 8, 2);
  addDoor({2.3, 4.4});  // half a metre off
  addDoor({2.0, 3.2});  // the same again
  addDoor({6.0, 4.0});  // is closed
  const auto result = evaluate();
  EXPECT_EQ(result.doors, 1U);
  EXPECT_EQ(result.doorsTold, 3U);
  EXPECT_EQ(result.doorsFound, 1U);
}

TEST_F(RoomEvaluationTest, TheMapMayHaveAFrameOfItsOwn) {
  for (auto& room : truth_.rooms) {
    for (auto& corner_m : room.polygon_m) corner_m = {10.0 - corner_m.y(), corner_m.x()};  // turned by 90 degrees
  }
  addRoom(0, 0, 4, 4);
  addRoom(4, 0, 4, 4);
  addRoom(0, 4, 8, 2);
  const Eigen::Isometry2d T_truth_map = Eigen::Translation2d(10.0, 0.0) * Eigen::Rotation2Dd(M_PI / 2);
  EXPECT_EQ(evaluate(T_truth_map).found, 3U);
  EXPECT_EQ(evaluate().found, 0U);
  EXPECT_TRUE(std::isnan(evaluate().meanOverlap()));
}

TEST(TrueDoorTest, IsAsFreeAsTheGapBesideItsLeaf) {
  TrueBuilding::Door door{"a", "b", {0, 0}, {1.35, 0}, true, 0.417};
  EXPECT_NEAR(door.free_m(), 2.7 * 0.20699, 1e-4);  // the chord: twice the width times sin(0.2085)
  door.open_rad = M_PI / 2;
  EXPECT_DOUBLE_EQ(door.free_m(), 1.35) << "no wider than its frame";
  door.open_rad = 0.0;
  EXPECT_DOUBLE_EQ(door.free_m(), 0.0);
  door.hasLeaf = false;
  EXPECT_DOUBLE_EQ(door.free_m(), 1.35);
}

}  // namespace
}  // namespace wardslam::evaluation
