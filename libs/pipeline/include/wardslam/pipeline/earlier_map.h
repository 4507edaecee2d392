#pragma once

#include <filesystem>

#include "wardslam/graph/mapper.h"
#include "wardslam/graph/saved_graph.h"
#include "wardslam/mapping/map_memory.h"
#include "wardslam/mapping/semantic_map.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::pipeline {

/// What an earlier run learnt of the place, to go on with. The camera may start anywhere in it: tracking has a map of
/// its own until a place of the earlier map is recognised, then both are one.
struct EarlierMap {
  graph::SavedGraph graph;
  mapping::SemanticMap semantic;  ///< Without keyframes: only where the camera is matters.
  graph::Saved use = graph::Saved::MayChange;
  mapping::MapMemory memory{};  ///< Of the semantic map; empty: made up from what that shows.
};

/// Without the cloud where the map is only to find oneself in (Saved::IsHeld). Throws core::InputError naming the file
/// when it is damaged or holds nothing a camera could be recognised by.
[[nodiscard]] EarlierMap readEarlierMap(const std::filesystem::path& file, graph::Saved use = graph::Saved::MayChange,
                                        storage::MapAccess access = storage::MapAccess::Read);

}  // namespace wardslam::pipeline
