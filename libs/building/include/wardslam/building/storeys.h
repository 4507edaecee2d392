#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::building {

/// Keyframes that stand on floor of about one height: from one to the next no more than a metre, as up a ramp.
struct Storey {
  double lowest_m = 0.0;  ///< Of its floor, z in the map frame,
  double highest_m = 0.0;
  std::set<std::uint64_t> keyframes;
  bool hasPlan = false;  ///< The map's floor plan, and so its rooms, are of this one: that with most keyframes.
};

/// From the lowest up, of the piece that is the map. Nothing where no keyframe saw the floor.
[[nodiscard]] std::vector<Storey> storeysOf(const mapping::SemanticMap& map);

/// The storey that something is on, by the z (m, map frame) of its middle: the highest whose floor is beneath it, or no
/// more than half a metre over it. The lowest for what is beneath them all. `storeys` are not empty.
[[nodiscard]] const Storey& storeyAt(const std::vector<Storey>& storeys, double z_map_m);

/// Whether that is the one with the plan; also where no storeys are known.
[[nodiscard]] bool isOnPlan(const std::vector<Storey>& storeys, double z_map_m);

}  // namespace wardslam::building
