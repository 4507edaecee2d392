#include "hospital/hospital_truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "hospital/hospital_furnishing.h"
#include "support/temporary_folder.h"
#include "wardslam/mapping/zones.h"

namespace wardslam::synth {
namespace {

class HospitalTruth : public ::testing::Test {
 protected:
  HospitalPlan plan = planHospital(1);
  HospitalDay today = daysLater(plan, furnish(plan, 1, true), 2, 1);
};

TEST_F(HospitalTruth, RoomsAreClosedPolygonsAndDoorsLinesBetweenThem) {
  const auto json = nlohmann::json::parse(roomsGeoJson({&plan}));
  std::size_t rooms = 0;
  std::size_t doors = 0;
  for (const auto& feature : json["features"]) {
    const auto& coordinates = feature["geometry"]["coordinates"];
    if (feature["properties"]["what"] == "room") {
      ++rooms;
      EXPECT_EQ(feature["geometry"]["type"], "Polygon");
      ASSERT_EQ(coordinates[0].size(), 5U);
      EXPECT_EQ(coordinates[0].front(), coordinates[0].back());
    } else if (feature["properties"]["what"] == "door") {
      ++doors;
      EXPECT_EQ(coordinates.size(), 2U);
      EXPECT_EQ(feature["properties"]["rooms"].size(), 2U);
    }
  }
  EXPECT_EQ(rooms, plan.rooms.size());
  EXPECT_EQ(doors, plan.doors.size());
}

TEST_F(HospitalTruth, TellsStoreysApart) {
  const HospitalPlan above = planHospital(1, 1);
  const auto json = nlohmann::json::parse(roomsGeoJson({&plan, &above}));
  std::map<int, std::size_t> features;
  std::set<std::string> ids;
  for (const auto& feature : json["features"]) {
    const auto& properties = feature["properties"];
    ++features[properties["storey"]];
    const bool isNew = !properties.contains("id") || ids.insert(properties["id"]).second;
    EXPECT_TRUE(isNew) << properties;
  }
  EXPECT_EQ(features[0], plan.rooms.size() + plan.doors.size() + 1);
  EXPECT_EQ(features[1], above.rooms.size() + above.doors.size() + 1);
  const HospitalDay todayAbove = daysLater(above, furnish(above, 1, true), 2, 1);
  const std::string days = daysCsv({{plan, today}, {above, todayAbove}});
  EXPECT_EQ(static_cast<std::size_t>(std::count(days.begin(), days.end(), '\n')),
            1 + today.changes.size() + todayAbove.changes.size());
}

TEST_F(HospitalTruth, RoomsAndDoorsLieWhereThePlanHasThem) {
  const auto pointOf = [](const nlohmann::json& xy) -> Eigen::Vector2d {
    return {xy[0].get<double>(), xy[1].get<double>()};
  };
  const auto json = nlohmann::json::parse(roomsGeoJson({&plan}));
  std::map<std::string, std::vector<Eigen::Vector2d>> corners_m;
  std::vector<Eigen::Vector2d> ends_m;
  for (const auto& feature : json["features"]) {
    const auto& coordinates = feature["geometry"]["coordinates"];
    if (feature["properties"]["what"] == "room") {
      for (const auto& corner : coordinates[0]) corners_m[feature["properties"]["id"]].push_back(pointOf(corner));
    } else if (feature["properties"]["what"] == "door") {
      for (const auto& end : coordinates) ends_m.push_back(pointOf(end));
    }
  }
  constexpr double kMillimetre_m = 0.001;
  for (const Room& room : plan.rooms) {
    const auto& is_m = corners_m[room.id];
    const Eigen::Vector2d low = room.area_m.min();
    const Eigen::Vector2d high = room.area_m.max();
    const std::vector<Eigen::Vector2d> expected_m = {low, {high.x(), low.y()}, high, {low.x(), high.y()}, low};
    ASSERT_EQ(is_m.size(), expected_m.size()) << room.id;
    for (std::size_t i = 0; i < is_m.size(); ++i) EXPECT_LT((is_m[i] - expected_m[i]).norm(), kMillimetre_m) << room.id;
  }
  ASSERT_EQ(ends_m.size(), 2 * plan.doors.size());
  for (std::size_t i = 0; i < plan.doors.size(); ++i) {
    EXPECT_LT((ends_m[2 * i] - plan.doors[i].from_m).norm(), kMillimetre_m) << "door " << i + 1;
    EXPECT_LT((ends_m[2 * i + 1] - plan.doors[i].to_m).norm(), kMillimetre_m) << "door " << i + 1;
  }
}

TEST_F(HospitalTruth, ZonesAreReadAsZones) {
  const test::TemporaryFolder folder;
  const auto zones = mapping::Zones::fromFile(folder.write("zones.yaml", zonesYaml(plan)));
  EXPECT_EQ(zones.all().size(), plan.rooms.size());
  for (const Room& room : plan.rooms) {
    EXPECT_EQ(zones.at(room.area_m.center()), room.id);
    EXPECT_EQ(zones.at(room.area_m.max() - Eigen::Vector2d(0.01, 0.01)), room.id);
  }
}

TEST_F(HospitalTruth, EveryChangeIsALineWithTwoPlaces) {
  std::istringstream text(daysCsv({{plan, today}}));
  std::string line;
  std::getline(text, line);
  EXPECT_EQ(line, "day,identity,name,class_name,what,from_room,from_x,from_y,from_yaw,to_room,to_x,to_y,to_yaw");
  std::size_t lines = 0;
  for (; std::getline(text, line); ++lines) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 12) << line;
    const bool isNew = line.find(",new,,,,,") != std::string::npos;
    const bool isGone = line.find(",gone,") != std::string::npos && line.substr(line.size() - 4) == ",,,,";
    EXPECT_EQ(isNew, line.find(",new,") != std::string::npos) << line;
    EXPECT_EQ(isGone, line.find(",gone,") != std::string::npos) << line;
  }
  EXPECT_EQ(lines, today.changes.size());
}

TEST_F(HospitalTruth, ThePlanIsDrawn) {
  const HospitalRoute route(plan, {RouteKind::Round, 0}, 1);
  const cv::Mat picture = planPicture(plan, today, route, 30.0);
  EXPECT_NEAR(picture.cols, plan.size_m.x() * 40 + 60, 2);
  EXPECT_NEAR(picture.rows, plan.size_m.y() * 40 + 60, 2);
  const cv::Mat without = planPicture(plan, today, route, 0.0);
  EXPECT_GT(cv::norm(picture, without, cv::NORM_L1), 1000.0) << "the way that was driven";
}

}  // namespace
}  // namespace wardslam::synth
