#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "wardslam/bags/bag_damage.h"
#include "wardslam/bags/byte_view.h"

namespace wardslam::bags {

/// Takes little-endian numbers and counted strings from the records of a bag, and never reads beyond them.
class ByteCursor {
 public:
  /// `what` begins the sentence of the BagDamage that is thrown where the bytes end too early.
  ByteCursor(ByteView bytes, std::string what) : bytes_(bytes), what_(std::move(what)) {}

  [[nodiscard]] std::size_t left() const { return bytes_.size - position_; }
  [[nodiscard]] std::size_t position() const { return position_; }

  ByteView take(std::uint64_t count) {
    if (count > left()) {
      throw BagDamage("sources.bag_damaged", what_ + " says that " + std::to_string(count) + " bytes follow, but " +
                                                 std::to_string(left()) + " are left");
    }
    const ByteView taken(bytes_.data + position_, static_cast<std::size_t>(count));
    position_ += taken.size;
    return taken;
  }

  template <class Number>
  Number number() {
    const ByteView raw = take(sizeof(Number));
    std::uint64_t value = 0;
    for (std::size_t i = sizeof(Number); i-- > 0;) value = value << 8U | raw.data[i];
    return static_cast<Number>(value);
  }

  /// With a count of 32 bits before it.
  ByteView counted() { return take(number<std::uint32_t>()); }
  std::string text() {
    const ByteView raw = counted();
    return {reinterpret_cast<const char*>(raw.data), raw.size};
  }

 private:
  ByteView bytes_;
  std::string what_;
  std::size_t position_ = 0;
};

}  // namespace wardslam::bags
