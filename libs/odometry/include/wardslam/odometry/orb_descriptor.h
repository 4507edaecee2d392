#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "wardslam/core/keypoint.h"

namespace wardslam::odometry {

/// 256 binary tests, packed.
using OrbDescriptor = std::array<std::uint8_t, 32>;

[[nodiscard]] inline OrbDescriptor descriptorOf(const core::Features& features, std::size_t keypoint) {
  OrbDescriptor descriptor;
  std::memcpy(descriptor.data(), features.descriptors.ptr(static_cast<int>(keypoint)), descriptor.size());
  return descriptor;
}

}  // namespace wardslam::odometry
