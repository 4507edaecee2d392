#pragma once

#include <cstdint>
#include <cstring>
#include <string>

#include "wardslam/bags/bag_damage.h"
#include "wardslam/bags/bag_reader.h"
#include "wardslam/bags/byte_view.h"

namespace wardslam::bags {

/// Takes the fields of a serialised message one after the other, as ROS 1 writes them (little-endian, without gaps) or
/// as ROS 2 does: CDR of OMG's DDS-XTYPES 1.3, 7.4.1 (either byte order; numbers lie at multiples of their size,
/// counted from behind the header of four bytes; texts end with a zero). Throws BagDamage beyond the end of the
/// message.
class FieldReader {
 public:
  FieldReader(ByteView message, Wire wire);

  template <class Number>
  Number number() {
    static_assert(sizeof(Number) <= sizeof(std::uint64_t));
    if (isCdr_) align(sizeof(Number));
    const ByteView raw = take(sizeof(Number));
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      const std::size_t at = isBigEndian_ ? i : sizeof(Number) - 1 - i;
      bits = bits << 8U | raw.data[at];
    }
    return fromBits<Number>(bits);
  }

  std::string text();

  /// A sequence of bytes; they lie in the message.
  ByteView bytes();

  /// The count that begins a sequence whose elements take at least so many bytes each.
  std::size_t count(std::size_t leastElement_bytes);

  [[nodiscard]] Wire wire() const { return isCdr_ ? Wire::Cdr : Wire::Ros1; }

 private:
  template <class Number>
  static Number fromBits(std::uint64_t bits) {
    if constexpr (sizeof(Number) == sizeof(std::uint64_t)) {
      return copied<Number>(bits);
    } else if constexpr (sizeof(Number) == sizeof(std::uint32_t)) {
      return copied<Number>(static_cast<std::uint32_t>(bits));
    } else {
      return static_cast<Number>(bits);
    }
  }
  template <class Number, class Bits>
  static Number copied(Bits bits) {
    Number number;
    std::memcpy(&number, &bits, sizeof number);
    return number;
  }

  ByteView take(std::size_t size);
  void align(std::size_t size);

  ByteView message_;
  std::size_t position_ = 0;
  std::size_t origin_ = 0;  ///< From where alignment counts.
  bool isCdr_ = false;
  bool isBigEndian_ = false;
};

}  // namespace wardslam::bags
