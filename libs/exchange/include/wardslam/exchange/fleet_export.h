#pragma once

#include <filesystem>

#include "wardslam/building/route_network.h"
#include "wardslam/mapping/semantic_map.h"

/// Zones and ways for programs that lead fleets of robots; docs/map.md says what each holds. Everything is in the map
/// frame, metres. A file is complete or absent. All throw core::InputError when it cannot be written.
namespace wardslam::exchange {

/// The zones as a zoneSet message of VDA 5050, version 3.0.0, of a map and set called `id`: forbidden zones are
/// BLOCKED, slow ones SPEED_LIMIT, one-way ones DIRECTED (RESTRICTED), the others ACTION and RELEASE. Places ask for
/// nothing and are left out.
void exportZoneSet(const mapping::SemanticMap& map, const std::string& id, const std::filesystem::path& file);

/// A filter mask of Nav2 for its KeepoutFilter: `file` (YAML of map_server) and an image beside it, `.pgm`, with the
/// raster of the floor plan; forbidden zones are 100, all else 0. Throws where the map has no floor plan.
void exportKeepoutMask(const mapping::SemanticMap& map, const std::filesystem::path& file);

/// Likewise for its SpeedFilter: the limit is `multiplier` times the value in the mask, in m/s (type 2, base 0); 0 is
/// no limit. Also `.filter_info.yaml` beside it, which tells the multiplier to the costmap filter info server.
void exportSpeedMask(const mapping::SemanticMap& map, const std::filesystem::path& file);

/// A graph of Nav2's route server, GeoJSON: waypoints are nodes in the frame `map`, lanes directed edges, with their
/// limit as `abs_speed_limit` (m/s).
void exportNav2Route(const building::RouteNetwork& network, const std::filesystem::path& file);

/// A navigation graph of Open-RMF (YAML) with one level, called as its maps call the storey.
void exportRmfGraph(const building::RouteNetwork& network, const std::string& level, const std::filesystem::path& file);

}  // namespace wardslam::exchange
