#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/map_export.h"

namespace wardslam::exchange {
namespace {

using nlohmann::json;

class ExportObjectsTest : public testing::Test {
 protected:
  json features() const {
    exportGeoJson(ward_, folder_.path() / "ward.geojson");
    const json collection = json::parse(test::readText(folder_.path() / "ward.geojson"));
    EXPECT_EQ(collection["type"], "FeatureCollection");
    return collection["features"];
  }
  std::vector<std::string> csvLines() const {
    exportCsv(ward_, folder_.path() / "ward.csv");
    std::istringstream text(test::readText(folder_.path() / "ward.csv"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
  }

  mapping::SemanticMap ward_ = test::makeWard();
  test::TemporaryFolder folder_;
};

TEST_F(ExportObjectsTest, GeoJsonHasZonesAndWhatStandsThere) {
  const json all = features();
  ASSERT_EQ(all.size(), 2U + 6U);
  EXPECT_EQ(all[1]["properties"]["kind"], "zone");
  EXPECT_EQ(all[1]["properties"]["name"], "clean zone");
  EXPECT_EQ(all[1]["geometry"]["type"], "Polygon");
  EXPECT_EQ(all[1]["geometry"]["coordinates"], json::parse("[[[-1,-1],[3,-1],[3,5],[-1,5],[-1,-1]]]"));
  const json bed = all[6];
  EXPECT_EQ(bed["properties"]["class_name"], "bed");
  EXPECT_EQ(bed["properties"]["state"], "static");
  EXPECT_EQ(bed["geometry"]["coordinates"], json::parse("[[[5.0,2.0],[6.0,2.0],[6.0,4.0],[5.0,4.0],[5.0,2.0]]]"));
}

TEST_F(ExportObjectsTest, RingsRunCounterClockwiseWhicheverWayAZoneIsGiven) {
  ward_.zones = {{"ward", {{0, 0}, {0, 1}, {1, 1}}}};
  EXPECT_EQ(features()[0]["geometry"]["coordinates"], json::parse("[[[1,1],[0,1],[0,0],[1,1]]]"));
}

TEST_F(ExportObjectsTest, CsvHasOneLinePerObject) {
  const auto lines = csvLines();
  ASSERT_EQ(lines.size(), 1U + 7U);
  EXPECT_EQ(lines[0].substr(0, 36), "id,class_id,class_name,centroid_x,ce");
  EXPECT_EQ(lines[3],
            "3,25,backpack,2.0000,2.0000,0.6000,1.8500,1.8500,0.4000,2.1500,2.1500,0.8000,0.7500,5,900.0000,"
            "999.0000,clean zone,static");
  EXPECT_NE(lines[6].find(",gone"), std::string::npos);
}

TEST_F(ExportObjectsTest, CsvQuotesWhatNeedsIt) {
  ward_.labels.rename(57, "chair, \"blue\"");
  EXPECT_EQ(csvLines()[1].substr(0, 26), "1,57,\"chair, \"\"blue\"\"\",0.0");
}

TEST_F(ExportObjectsTest, WhatCannotBeWrittenIsAnInputError) {
  EXPECT_THROW(exportGeoJson(ward_, folder_.path() / "missing" / "a"), core::InputError);
  EXPECT_THROW(exportCsv(ward_, folder_.path() / "missing" / "a"), core::InputError);
}

}  // namespace
}  // namespace wardslam::exchange
