#pragma once

#include <optional>
#include <string>

namespace mrpt::obs {
class CObservation3DRangeScan;
}

namespace wardslam::sources {

/// What keeps the observation from becoming a frame, as the end of a sentence ("has no calibration"); nothing when
/// all is well. Its images must be in memory.
[[nodiscard]] std::optional<std::string> whyUnusable(const mrpt::obs::CObservation3DRangeScan& observation);

}  // namespace wardslam::sources
