#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/fleet_export.h"

namespace wardslam::exchange {
namespace {

using mapping::ZoneType;
using nlohmann::json;

/// What VDA 5050 3.0.0 asks of a zoneSet: chapter 6.4 and its schema.
class ExportZoneSetTest : public testing::Test {
 protected:
  json exported() const {
    exportZoneSet(ward_, "ward 3", file_);
    return json::parse(std::ifstream(file_));
  }

  mapping::SemanticMap ward_ = test::makeWard();
  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "zones.json";
};

TEST_F(ExportZoneSetTest, HasTheHeaderOfAMessage) {
  ward_.keyframes.clear();
  ward_.keyframes[1].stamp_s = 1700000000.25;
  const json message = exported();
  EXPECT_TRUE(message.at("headerId").is_number_integer());
  EXPECT_EQ(message.at("timestamp"), "2023-11-14T22:13:20.000Z");
  EXPECT_EQ(message.at("version"), "3.0.0");
  EXPECT_TRUE(message.at("manufacturer").is_string());
  EXPECT_TRUE(message.at("serialNumber").is_string());
  EXPECT_EQ(message.at("zoneSet").at("mapId"), "ward 3");
  EXPECT_EQ(message.at("zoneSet").at("zoneSetId"), "ward 3 zones");
}

TEST_F(ExportZoneSetTest, PlacesAskForNothing) { EXPECT_EQ(exported().at("zoneSet").at("zones"), json::array()); }

TEST_F(ExportZoneSetTest, EveryTypeHasItsNameAndWhatItNeeds) {
  const std::vector<Eigen::Vector2d> polygon_m{{0, 0}, {2, 0}, {2, 1.5}};
  ward_.zones = {{"no", polygon_m, ZoneType::Forbidden},
                 {"slow", polygon_m, ZoneType::Slow, 0.3},
                 {"lane", polygon_m, ZoneType::OneWay, 0.0, 1.5 * M_PI},
                 {"bell", polygon_m, ZoneType::Action, 0.0, 0.0, {{"ring"}, {}, {"hush"}}},
                 {"gate", polygon_m, ZoneType::Release}};
  const json zones = exported().at("zoneSet").at("zones");
  ASSERT_EQ(zones.size(), 5U);
  EXPECT_EQ(zones[0], json::parse(R"({"zoneId": "no", "zoneType": "BLOCKED", "zoneDescriptor": "no",
    "vertices": [{"x": 0.0, "y": 0.0}, {"x": 2.0, "y": 0.0}, {"x": 2.0, "y": 1.5}]})"));
  EXPECT_EQ(zones[1].at("zoneType"), "SPEED_LIMIT");
  EXPECT_EQ(zones[1].at("maximumSpeed"), 0.3);
  EXPECT_EQ(zones[2].at("zoneType"), "DIRECTED");
  EXPECT_NEAR(zones[2].at("direction").get<double>(), -M_PI / 2.0, 1e-12);
  EXPECT_EQ(zones[2].at("limitation"), "RESTRICTED") << "never against it";
  EXPECT_EQ(zones[3].at("zoneType"), "ACTION");
  EXPECT_EQ(zones[3].at("entryActions"), json::parse(R"([{"actionType": "ring", "blockingType": "NONE"}])"));
  EXPECT_EQ(zones[3].at("duringActions"), json::array()) << "must be there, and may be empty";
  EXPECT_EQ(zones[3].at("exitActions").size(), 1U);
  EXPECT_EQ(zones[4].at("zoneType"), "RELEASE");
}

TEST_F(ExportZoneSetTest, WhatCannotBeWrittenIsAnInputError) {
  EXPECT_THROW(exportZoneSet(ward_, "w", folder_.path() / "missing" / "zones.json"), core::InputError);
}

}  // namespace
}  // namespace wardslam::exchange
