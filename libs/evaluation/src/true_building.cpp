#include "wardslam/evaluation/true_building.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "wardslam/core/errors.h"

namespace wardslam::evaluation {
namespace {

using Json = nlohmann::json;

std::vector<Eigen::Vector2d> placesOf(const Json& coordinates) {
  std::vector<Eigen::Vector2d> places_m;
  for (const Json& place : coordinates) places_m.emplace_back(place.at(0).get<double>(), place.at(1).get<double>());
  return places_m;
}

TrueBuilding::Room roomOf(const Json& properties, const Json& coordinates) {
  TrueBuilding::Room room{properties.at("id"), properties.at("name"), placesOf(coordinates.at(0))};
  if (room.polygon_m.size() > 1 && room.polygon_m.front() == room.polygon_m.back()) room.polygon_m.pop_back();
  if (room.polygon_m.size() < 3) throw core::InputError("room '" + room.id + "' has less than three corners");
  return room;
}

TrueBuilding::Door doorOf(const Json& properties, const Json& coordinates) {
  TrueBuilding::Door door;
  door.room = properties.at("rooms").at(0);
  door.other = properties.at("rooms").at(1);
  door.from_m = placesOf(coordinates).at(0);
  door.to_m = placesOf(coordinates).at(1);
  door.hasLeaf = properties.at("state") != "passage";
  door.open_rad = properties.at("open_rad");
  return door;
}

}  // namespace

TrueBuilding readTrueBuilding(const std::filesystem::path& file, int storey) {
  std::ifstream in(file);
  if (!in) throw core::InputError(file.string() + ": cannot be read");
  TrueBuilding building;
  try {
    const Json collection = Json::parse(in);
    for (const Json& feature : collection.at("features")) {
      const Json& properties = feature.at("properties");
      if (properties.value("storey", 0) != storey) continue;
      const Json& coordinates = feature.at("geometry").at("coordinates");
      const std::string what = properties.value("what", "");
      if (what == "room") building.rooms.push_back(roomOf(properties, coordinates));
      if (what == "door") building.doors.push_back(doorOf(properties, coordinates));
    }
  } catch (const std::exception& error) {
    throw core::InputError(file.string() + ": is not the rooms.geojson of rawlog-synth: " + error.what());
  }
  if (building.rooms.empty())
    throw core::InputError(file.string() + ": holds no room of storey " + std::to_string(storey));
  return building;
}

}  // namespace wardslam::evaluation
