#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "wardslam/building/room_finder.h"
#include "wardslam/mapping/semantic_map.h"

/// What maps are asked, wherever they come from, and the answers as tables or JSON.
namespace wardslam::apps {

/// Which things, and where.
struct MapQuestion {
  std::string className;
  std::string zone;
  std::string room;
  std::string state;
  std::vector<double> box_m;    ///< x0 y0 z0 x1 y1 z1
  std::vector<double> point_m;  ///< x y [z]
  std::optional<double> unseenFor_s;
  std::optional<double> seenWithin_s;
  bool free = false;
  bool alongFloor = false;
  building::RoomOptions rooms;
  std::filesystem::path picture;  ///< Of the rooms.
  bool json = false;
};

// Print on standard output. Throw core::InputError for names that the map does not know.
void answerObjects(const MapQuestion& question, const mapping::SemanticMap& map);
void answerNearest(const MapQuestion& question, const mapping::SemanticMap& map);
void answerPlace(const MapQuestion& question, const mapping::SemanticMap& map);
void answerZones(const MapQuestion& question, const mapping::SemanticMap& map);

void addJson(CLI::App& verb, MapQuestion& question);
void addObjectsOptions(CLI::App& verb, MapQuestion& question);
void addNearestOptions(CLI::App& verb, MapQuestion& question);
void addPlaceOptions(CLI::App& verb, MapQuestion& question);

}  // namespace wardslam::apps
