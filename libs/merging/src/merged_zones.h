#pragma once

#include <string>
#include <vector>

#include "joined_runs.h"
#include "wardslam/mapping/zone.h"

namespace wardslam::merging {

struct MergedZones {
  std::vector<mapping::Zone> zones;  ///< In the frame of the joined map.
  std::vector<std::string> notes;    ///< One sentence for each that is not there as somebody drew it.
};

/// Zones go with the keyframe nearest to them. Of one name there is one: where two maps have it elsewhere (less than
/// nine tenths in common) that of the later map stays, and it is said. Zones of a map that is no part of the joined one
/// are left out, and it is said.
[[nodiscard]] MergedZones mergeZones(const std::vector<Run>& runs, const JoinedRuns& joined);

}  // namespace wardslam::merging
