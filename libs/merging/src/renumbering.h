#pragma once

#include <map>
#include <vector>

#include "wardslam/pipeline/earlier_map.h"

namespace wardslam::merging {

/// From old numbers to new ones, of one map.
struct Numbers {
  std::map<graph::KeyframeId, graph::KeyframeId> keyframes;
  std::map<graph::PointId, graph::PointId> points;
  std::map<std::uint32_t, std::uint32_t> pieces;
  mapping::ObjectId objectsBefore = 0;  ///< Numbers of things go on behind those of the maps before.

  [[nodiscard]] mapping::ObjectId object(mapping::ObjectId id) const { return id == 0 ? 0 : id + objectsBefore; }
};

/// Gives every piece, keyframe, point and thing of the maps a number that none of the others has, in the order of the
/// maps: keyframes and points without gaps from 1; pieces likewise, first those that are the maps. Returns what became
/// of the numbers, map by map.
std::vector<Numbers> renumber(const std::vector<pipeline::EarlierMap*>& maps);

using ShownTiles = std::map<graph::KeyframeId, mapping::SemanticCloudTile>;
using TileMemories = std::map<graph::KeyframeId, mapping::TileMemory>;

/// The cloud of a map that was renumbered without it.
[[nodiscard]] ShownTiles renumbered(ShownTiles tiles, const Numbers& numbers);
[[nodiscard]] TileMemories renumbered(TileMemories tiles, const Numbers& numbers);

}  // namespace wardslam::merging
