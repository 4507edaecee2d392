#pragma once

#include <optional>
#include <string>

namespace mrpt::obs {
class CObservation3DRangeScan;
class CObservationStereoImages;
}  // namespace mrpt::obs

namespace wardslam::sources {

/// What keeps the observation from becoming a frame, as the end of a sentence ("has no calibration"); nothing when
/// all is well. Its images must be in memory.
[[nodiscard]] std::optional<std::string> whyUnusable(const mrpt::obs::CObservation3DRangeScan& observation);

/// The same for what keeps a stereo pair from becoming one.
[[nodiscard]] std::optional<std::string> whyUnusable(const mrpt::obs::CObservationStereoImages& pair);

}  // namespace wardslam::sources
