#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace wardslam::bags {

using Bytes = std::vector<std::uint8_t>;

/// A run of bytes that somebody else keeps.
struct ByteView {
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;

  ByteView() = default;
  ByteView(const std::uint8_t* first, std::size_t count) : data(first), size(count) {}
  ByteView(const Bytes& bytes) : data(bytes.data()), size(bytes.size()) {}  // NOLINT(google-explicit-constructor)
};

}  // namespace wardslam::bags
