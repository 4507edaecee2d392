#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "wardslam/core/keypoint.h"

namespace wardslam::pipeline {

/// How many of them are left out.
[[nodiscard]] inline std::size_t countDynamic(const std::vector<core::Keypoint>& keypoints) {
  return static_cast<std::size_t>(std::count_if(
      keypoints.begin(), keypoints.end(), [](const auto& point) { return point.motion == core::Motion::Dynamic; }));
}

}  // namespace wardslam::pipeline
