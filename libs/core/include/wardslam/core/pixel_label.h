#pragma once

#include <cstdint>

namespace wardslam::core {

/// Meaning of the bits in Frame::labelBits and in CObservation3DRangeScan::pixelLabels, and their names there.
enum class PixelLabel : std::uint8_t { Dynamic = 0, Movable = 1, Person = 2, Thing = 3 };

[[nodiscard]] constexpr std::uint8_t bitOf(PixelLabel label) {
  return static_cast<std::uint8_t>(1U << static_cast<unsigned>(label));
}

}  // namespace wardslam::core
