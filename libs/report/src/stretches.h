#pragma once

#include <cstddef>
#include <vector>

#include "wardslam/pipeline/frame_table.h"

namespace wardslam::report {

enum class Ending {
  Begins,      ///< Tracking had not begun before.
  Found,       ///< In the piece it was lost in.
  BegunAnew,   ///< In another piece.
  NotAnymore,  ///< The run ended.
};

/// Successive frames without a pose.
struct Stretch {
  double from_s = 0.0;  ///< Of its first frame.
  double to_s = 0.0;    ///< Of the frame that has a pose again, or its last one.
  std::size_t frames = 0;
  Ending ending = Ending::NotAnymore;
};

/// `frames` in order of time.
[[nodiscard]] std::vector<Stretch> stretchesWithoutPose(const std::vector<pipeline::FrameRow>& frames);

}  // namespace wardslam::report
