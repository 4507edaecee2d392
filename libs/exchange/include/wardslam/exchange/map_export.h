#pragma once

#include <filesystem>

#include "wardslam/building/rooms.h"
#include "wardslam/mapping/semantic_map.h"

/// The map in formats that other programs read; docs/map.md says what each holds. Everything is in the map frame,
/// metres. A file is complete or absent. All throw core::InputError when it cannot be written.
namespace wardslam::exchange {

/// The cloud: x y z red green blue scalar_class scalar_instance label, binary; label is the class once more.
void exportPly(const mapping::SemanticMap& map, const std::filesystem::path& file);

/// The cloud: x y z rgb label instance, binary.
void exportPcd(const mapping::SemanticMap& map, const std::filesystem::path& file);

/// Occupied space from the cloud, free space between it and the cameras, in cells of `resolution_m`; `.bt`, or with
/// probabilities `.ot`.
void exportOctomap(const mapping::SemanticMap& map, const std::filesystem::path& file, double resolution_m = 0.05);

/// The floor plan as MRPT's COccupancyGridMap2D (`.gridmap`). Throws where the map has no floor plan.
void exportGridmap(const mapping::SemanticMap& map, const std::filesystem::path& file);

/// The floor plan for ROS map_server: `file` (YAML) and an image beside it, `.pgm`. Throws where there is none.
void exportRosMap(const mapping::SemanticMap& map, const std::filesystem::path& file);

/// MRPT's `.simplemap`, see toSimpleMap().
void exportSimpleMap(const mapping::SemanticMap& map, const std::filesystem::path& file);

/// Zones and objects (those that stand there) as polygons with their attributes. Coordinates are metres, not degrees,
/// which GeoJSON cannot say.
void exportGeoJson(const mapping::SemanticMap& map, const std::filesystem::path& file);

/// The same and more as OGC GeoPackage 1.3: layers `zones`, `rooms`, `objects` and `ways` (those driven) in an
/// undefined Cartesian reference system (srs_id -1), metres. The same map makes the same bytes.
void exportGeoPackage(const mapping::SemanticMap& map, const building::Rooms& rooms, const std::filesystem::path& file);

/// All objects, those that are gone included, one per line.
void exportCsv(const mapping::SemanticMap& map, const std::filesystem::path& file);

}  // namespace wardslam::exchange
