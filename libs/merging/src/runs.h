#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "renumbering.h"
#include "wardslam/merging/map_merge.h"
#include "wardslam/pipeline/earlier_map.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::merging {

/// A map that is to be made one with others.
struct Run {
  std::filesystem::path file;
  std::string name;  ///< The file without folders; with the last of them where others are called the same.
  storage::MapHeader header;
  pipeline::EarlierMap map;  ///< Without the cloud, which is by far the most of it.
  Numbers numbers;           ///< What became of those in the file.
};

/// All of a run's cloud, under the numbers of the run.
struct RunCloud {
  TileMemories known;
  ShownTiles shown;  ///< Of which no more is known.
};

/// From the file. Throws core::InputError.
[[nodiscard]] RunCloud readCloud(const Run& run);

/// Whether maps share keyframes: then one of them is the other, gone on with.
[[nodiscard]] bool shareKeyframes(const Run& a, const Run& b);

/// Reads the maps and leaves the files untouched. The oldest comes first, in whatever order they are named, and no two
/// share a number of a piece, keyframe, point or thing. Throws core::InputError for a map that cannot be read.
[[nodiscard]] std::vector<Run> readRuns(const std::vector<std::filesystem::path>& maps, const ProgressSink& progress);

/// Throws core::InputError where a class has another name or number in another map, and where maps share keyframes.
void requireThatTheyFit(const std::vector<Run>& runs);

}  // namespace wardslam::merging
