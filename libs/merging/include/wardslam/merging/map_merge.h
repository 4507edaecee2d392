#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "wardslam/pipeline/slam_options.h"

/// Maps that knew nothing of each other, made one.
namespace wardslam::merging {

/// How far a step is: maps read, keyframes that looked for places of other maps, parts written.
struct Progress {
  std::string unit;
  std::size_t done = 0;
  std::size_t total = 0;
};

/// Hears of progress. What it throws ends the work.
using ProgressSink = std::function<void(const Progress&)>;

struct MergeReport {
  struct Part {
    std::vector<std::string> files;  ///< Without folders where that tells them apart, the oldest first.
    std::size_t keyframes = 0;

    [[nodiscard]] std::string fileList() const;  ///< "a.wardmap, b.wardmap"
  };
  std::vector<Part> parts;         ///< What places connect is one part. The map, the largest, is the first.
  std::size_t placesFound = 0;     ///< Looks from keyframes of one map that found a place of another.
  std::vector<std::string> notes;  ///< What somebody should know: zones that do not fit together, say.
};

/// Reads maps, finds the places they have in common, adjusts one graph, makes points, cloud, things and zones one, and
/// writes `out`, which is there when it is complete. Work that was ended is kept beside it as `out`.merging, and gone
/// on from when the same maps are merged again with the same options; the result is the same. The maps are not touched.
/// It does not matter in which order they are named: the frame is that of the oldest map of the largest part. Of
/// `options`, those of the map, the graph and the knowledge count. Throws core::InputError.
MergeReport mergeMaps(const std::vector<std::filesystem::path>& maps, const std::filesystem::path& out,
                      const pipeline::SlamOptions& options, const ProgressSink& progress);

}  // namespace wardslam::merging
