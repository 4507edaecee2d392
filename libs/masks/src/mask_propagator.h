#pragma once

#include "wardslam/core/segmentation.h"
#include "wardslam/masks/image_motion.h"

namespace wardslam::masks {

/// Carries the masks of the picture at the start of `trail` to `now`, the picture at its end. They are warped along
/// the trail, then held against the depth image: what lies where the instance was expected stays, what proves to be
/// another surface goes, and what was hidden or moved otherwise joins when it lies beside the instance, in space too.
/// Where depth is missing, the motion of the image decides alone.
///
/// Ids, classes and confidences stay. An instance goes when it left the image or most of what can be seen of it is
/// another surface. `masks`: as large as the result; `now.gray` may be smaller (and its pixels square multiples).
/// Without instances there is nothing to carry, and the result shows nothing.
[[nodiscard]] core::Segmentation carryMasks(const core::Segmentation& masks, const Trail& trail,
                                            const SmallPicture& now);

}  // namespace wardslam::masks
