#pragma once

#include <SQLiteCpp/Database.h>

#include "wardslam/storage/map_file.h"

/// Reading of the tables. BlobError says which row is wrong.
namespace wardslam::storage {

[[nodiscard]] MapFileInfo readInfo(SQLite::Database& database);
[[nodiscard]] MapHeader readHeader(SQLite::Database& database);
[[nodiscard]] mapping::SemanticMap readMap(SQLite::Database& database, CloudPart cloud, PiecePart pieces);
[[nodiscard]] mapping::MapMemory readMemory(SQLite::Database& database);
[[nodiscard]] std::map<mapping::ObjectId, mapping::ObjectMemory> readObjectMemories(SQLite::Database& database);
[[nodiscard]] std::vector<odometry::Keyframe> readViews(SQLite::Database& database);
[[nodiscard]] std::map<odometry::PointId, Eigen::Vector3d> readPoints(SQLite::Database& database);
[[nodiscard]] std::vector<LoopEdge> readLoops(SQLite::Database& database);
[[nodiscard]] std::uint32_t readFreeSubmap(SQLite::Database& database);

}  // namespace wardslam::storage
