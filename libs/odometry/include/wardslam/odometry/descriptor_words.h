#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace wardslam::odometry {

/// The 256 bits of a descriptor, for who compares many of them.
using DescriptorWords = std::array<std::uint64_t, 4>;

/// Of 32 bytes.
[[nodiscard]] inline DescriptorWords wordsOf(const std::uint8_t* descriptor) {
  DescriptorWords words;
  std::memcpy(words.data(), descriptor, sizeof(words));
  return words;
}

/// Counted in all bytes at once ("SWAR"): not every processor that this is built for counts bits by itself, and to ask
/// for every pair which one it is, as OpenCV does, takes longer.
[[nodiscard]] inline int differingBits(const DescriptorWords& a, const DescriptorWords& b) {
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::uint64_t bits = a[i] ^ b[i];
    bits -= bits >> 1U & 0x5555555555555555U;
    bits = (bits & 0x3333333333333333U) + (bits >> 2U & 0x3333333333333333U);
    bytes += (bits + (bits >> 4U)) & 0x0F0F0F0F0F0F0F0FU;
  }
  const std::uint64_t pairs = (bytes & 0x00FF00FF00FF00FFU) + (bytes >> 8U & 0x00FF00FF00FF00FFU);
  return static_cast<int>(pairs * 0x0001000100010001U >> 48U);
}

}  // namespace wardslam::odometry
