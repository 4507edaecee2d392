#pragma once

#include <cstddef>
#include <cstdint>

namespace wardslam::mapping {

/// Neighbouring cells differ in few bits; this spreads them (finaliser of MurmurHash3, public domain).
struct CellHash {
  std::size_t operator()(std::uint64_t cell) const {
    cell ^= cell >> 33U;
    cell *= 0xFF51AFD7ED558CCDULL;
    cell ^= cell >> 33U;
    return static_cast<std::size_t>(cell);
  }
};

}  // namespace wardslam::mapping
