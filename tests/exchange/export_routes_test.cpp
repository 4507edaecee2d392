#include <gmock/gmock.h>
#include <yaml-cpp/yaml.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/fleet_export.h"

namespace wardslam::exchange {
namespace {

using nlohmann::json;

/// From a ward by a bend to a store, and back at half a metre a second on the second leg.
class ExportRoutesTest : public testing::Test {
 protected:
  building::RouteNetwork network_{{{"ward", {1.0, 2.0}}, {"", {1.5, 2.5}}, {"store: 4", {3.0, 2.5}}},
                                  {{0, 1, 0.0}, {1, 2, 0.0}, {2, 1, 0.5}}};
  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "routes";
};

/// Keys are those that nav2_route's GeoJsonGraphFileLoader reads.
TEST_F(ExportRoutesTest, AsAGraphOfNav2) {
  exportNav2Route(network_, file_);
  const json graph = json::parse(std::ifstream(file_));
  EXPECT_EQ(graph.at("type"), "FeatureCollection");
  const json& features = graph.at("features");
  ASSERT_EQ(features.size(), 6U);
  EXPECT_EQ(features[0], json::parse(R"({"type": "Feature", "geometry": {"type": "Point", "coordinates": [1.0, 2.0]},
    "properties": {"id": 0, "frame": "map", "metadata": {"name": "ward"}}})"));
  EXPECT_FALSE(features[1].at("properties").contains("metadata")) << "a bend has no name";
  EXPECT_EQ(features[5], json::parse(R"({"type": "Feature",
    "geometry": {"type": "MultiLineString", "coordinates": [[[3.0, 2.5], [1.5, 2.5]]]},
    "properties": {"id": 5, "startid": 2, "endid": 1, "metadata": {"abs_speed_limit": 0.5}}})"));
}

/// Keys are those that rmf_fleet_adapter's parse_graph() reads.
TEST_F(ExportRoutesTest, AsAGraphOfOpenRmf) {
  exportRmfGraph(network_, "L1", file_);
  const YAML::Node graph = YAML::LoadFile(file_.string());
  EXPECT_TRUE(graph["lifts"].IsMap());
  const YAML::Node level = graph["levels"]["L1"];
  ASSERT_EQ(level["vertices"].size(), 3U);
  EXPECT_EQ(level["vertices"][0][0].as<double>(), 1.0);
  EXPECT_EQ(level["vertices"][0][1].as<double>(), 2.0);
  EXPECT_EQ(level["vertices"][0][2]["name"].as<std::string>(), "ward");
  EXPECT_EQ(level["vertices"][1][2]["name"].as<std::string>(), "");
  EXPECT_EQ(level["vertices"][2][2]["name"].as<std::string>(), "store: 4");
  ASSERT_EQ(level["lanes"].size(), 3U);
  EXPECT_EQ(level["lanes"][2][0].as<int>(), 2);
  EXPECT_EQ(level["lanes"][2][1].as<int>(), 1);
  EXPECT_EQ(level["lanes"][2][2]["speed_limit"].as<double>(), 0.5);
  EXPECT_TRUE(level["lanes"][0][2].IsMap());
  EXPECT_FALSE(level["lanes"][0][2]["speed_limit"]);
}

TEST_F(ExportRoutesTest, WhatCannotBeWrittenIsAnInputError) {
  EXPECT_THROW(exportNav2Route(network_, file_ / "none" / "r"), core::InputError);
  EXPECT_THROW(exportRmfGraph(network_, "L1", file_ / "none" / "r"), core::InputError);
}

}  // namespace
}  // namespace wardslam::exchange
