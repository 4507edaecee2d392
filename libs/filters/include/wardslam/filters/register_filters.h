#pragma once

namespace wardslam::filters {

/// Makes the filters of this library known to MRPT's class registry. FilterChain calls it; to call it again does no
/// harm. Explicit, because a linker may drop the static initialisers of a static library.
void registerAllFilters();

}  // namespace wardslam::filters
