#pragma once

#include <utility>
#include <vector>

#include "object_database.h"
#include "object_table.h"
#include "semantic_cloud.h"

namespace wardslam::mapping {

/// Objects that are one thing because they are of one class and their boxes share most of the smaller, unless images
/// told them apart: {from, into}, the older one last. Boxes count as larger by `margin_m` on each side, for pictures
/// and screens are flat.
[[nodiscard]] std::vector<std::pair<ObjectId, ObjectId>> sameBoxes(const ObjectTable& table,
                                                                   const ObjectDatabase& database, double margin_m);

/// The objects that `found` was at places it has since been taken from: of its class, about as long, lost before it
/// was seen.
[[nodiscard]] std::vector<ObjectId> earlierPlacesOf(const MapObject& found, const ObjectTable& table,
                                                    const ObjectDatabase& database, const SemanticCloud& cloud);

}  // namespace wardslam::mapping
