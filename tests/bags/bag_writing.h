#pragma once

#include <cstdint>
#include <cstring>
#include <string>

#include "wardslam/bags/byte_view.h"

namespace wardslam::test {

/// Puts bytes together, as a recorder on a little-endian computer does.
class BytesMaker {
 public:
  template <class Number>
  BytesMaker& number(Number value) {
    const auto* raw = reinterpret_cast<const std::uint8_t*>(&value);
    bytes_.insert(bytes_.end(), raw, raw + sizeof value);
    return *this;
  }
  BytesMaker& raw(const std::string& text) {
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    return *this;
  }
  BytesMaker& raw(const bags::Bytes& bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return *this;
  }
  /// With a count of 32 bits before it, as ROS 1 writes texts.
  BytesMaker& text(const std::string& text) { return number(static_cast<std::uint32_t>(text.size())).raw(text); }

  [[nodiscard]] const bags::Bytes& bytes() const { return bytes_; }
  [[nodiscard]] std::string asText() const { return {bytes_.begin(), bytes_.end()}; }

 private:
  bags::Bytes bytes_;
};

}  // namespace wardslam::test
