#include "wardslam/evaluation/true_building.h"

#include <gmock/gmock.h>

#include <fstream>

#include "support/complaint.h"
#include "support/temporary_folder.h"

namespace wardslam::evaluation {
namespace {

using testing::HasSubstr;

class TrueBuildingTest : public testing::Test {
 protected:
  [[nodiscard]] TrueBuilding read(const std::string& features, int storey = 0) const {
    const auto file = folder_.path() / "rooms.geojson";
    std::ofstream(file) << R"({"type": "FeatureCollection", "features": [)" << features << "]}";
    return readTrueBuilding(file, storey);
  }

  test::TemporaryFolder folder_;
};

const std::string kRoom =
    R"({"properties": {"what": "room", "id": "w", "name": "WARD 1", "storey": 0},
        "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]]]}})";
const std::string kDoor =
    R"({"properties": {"what": "door", "rooms": ["w", "hall"], "storey": 0, "state": "ajar", "open_rad": 0.4},
        "geometry": {"type": "LineString", "coordinates": [[1, 3], [2, 3]]}})";
const std::string kElse = R"({"properties": {"what": "bare_walls", "storey": 0}, "geometry": {"coordinates": []}})";

TEST_F(TrueBuildingTest, HasRoomsAndDoors) {
  const auto building = read(kRoom + "," + kDoor + "," + kElse);
  ASSERT_EQ(building.rooms.size(), 1U);
  EXPECT_EQ(building.rooms[0].name, "WARD 1");
  EXPECT_EQ(building.rooms[0].polygon_m.size(), 4U) << "the last corner is the first again";
  ASSERT_EQ(building.doors.size(), 1U);
  EXPECT_EQ(building.doors[0].other, "hall");
  EXPECT_TRUE(building.doors[0].hasLeaf);
  EXPECT_DOUBLE_EQ(building.doors[0].open_rad, 0.4);
  EXPECT_DOUBLE_EQ(building.doors[0].width_m(), 1.0);
}

TEST_F(TrueBuildingTest, IsOfOneStorey) {
  EXPECT_THAT(test::complaintOf([&] { static_cast<void>(read(kRoom, 1)); }), HasSubstr("no room of storey 1"));
}

TEST_F(TrueBuildingTest, WhatIsNoneIsRefused) {
  const auto complaint = [&](const std::string& features) {
    return test::complaintOf([&] { static_cast<void>(read(features)); });
  };
  EXPECT_THAT(complaint("{"), HasSubstr("rooms.geojson: is not the rooms.geojson of rawlog-synth"));
  EXPECT_THAT(complaint(R"({"properties": {"what": "room"}, "geometry": {"coordinates": []}})"), HasSubstr("is not"));
  EXPECT_THAT(test::complaintOf([&] { static_cast<void>(readTrueBuilding(folder_.path() / "none.geojson")); }),
              HasSubstr("none.geojson: cannot be read"));
}

}  // namespace
}  // namespace wardslam::evaluation
