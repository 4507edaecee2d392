#pragma once

#include <string>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::query {

/// The object somebody means by "bed 2" (the second bed in order of ids), "bed #11" or "#11" (by its id), or "bed"
/// where only one stands. Objects that are gone keep their number, so that the others keep theirs. '_' and ' ' are one.
/// Throws core::InputError that says what there is instead.
[[nodiscard]] const mapping::MapObject& objectNamed(const mapping::SemanticMap& map, const std::string& name);

/// What objectNamed() takes for this object: "bed 2". `map` must hold it.
[[nodiscard]] std::string nameOf(const mapping::MapObject& object, const mapping::SemanticMap& map);

}  // namespace wardslam::query
