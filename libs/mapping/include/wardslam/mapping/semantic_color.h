#pragma once

#include <array>

#include "wardslam/core/label_space.h"

namespace wardslam::mapping {

/// The colour that stands for a class (P9), the same in every map; neighbouring ids look different. Black for 0.
/// The palette of the PASCAL VOC challenge: the bits of the id dealt out to the high bits of red, green and blue.
[[nodiscard]] std::array<std::uint8_t, 3> semanticColor(core::ClassId id);

}  // namespace wardslam::mapping
