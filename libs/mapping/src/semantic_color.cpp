#include "wardslam/mapping/semantic_color.h"

namespace wardslam::mapping {

std::array<std::uint8_t, 3> semanticColor(core::ClassId id) {
  std::array<std::uint8_t, 3> color{};
  for (unsigned bit = 0; bit < 8; ++bit) {
    const unsigned channel = bit % 3;
    const unsigned value = static_cast<unsigned>(id >> bit & 1U) << (7U - bit / 3U);
    color[channel] = static_cast<std::uint8_t>(color[channel] | value);
  }
  return color;
}

}  // namespace wardslam::mapping
