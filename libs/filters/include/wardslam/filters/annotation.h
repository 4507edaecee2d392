#pragma once

#include "wardslam/core/frame.h"

namespace wardslam::filters {

/// Writes what the filters found (Frame::labelBits) into the frame's observation, for stock MRPT programs
/// (core::annotate()). Does nothing without an observation, or where no filter said anything. An observation whose
/// range image is not of the size of the colour image stays as it is and counts as "filters.annotation_size".
void annotateObservation(core::Frame& frame);

}  // namespace wardslam::filters
