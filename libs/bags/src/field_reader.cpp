#include "field_reader.h"

namespace wardslam::bags {
namespace {

constexpr std::size_t kCdrHeader_bytes = 4;

}  // namespace

FieldReader::FieldReader(ByteView message, Wire wire) : message_(message), isCdr_(wire == Wire::Cdr) {
  if (wire == Wire::Unknown) {
    throw BagDamage("sources.message_unreadable", "is serialised neither as ROS 1 nor as CDR");
  }
  if (!isCdr_) return;
  const ByteView header = take(kCdrHeader_bytes);
  if (header.data[0] != 0 || header.data[1] > 1) {
    throw BagDamage("sources.message_unreadable",
                    "is serialised as kind " + std::to_string(256 * header.data[0] + header.data[1]) +
                        " of CDR, of which 0 and 1 are read, which all recorders of ROS 2 write");
  }
  isBigEndian_ = header.data[1] == 0;
  origin_ = position_;
}

std::string FieldReader::text() {
  const ByteView raw = bytes();
  std::string text(reinterpret_cast<const char*>(raw.data), raw.size);
  if (isCdr_ && !text.empty() && text.back() == '\0') text.pop_back();
  return text;
}

ByteView FieldReader::bytes() { return take(number<std::uint32_t>()); }

std::size_t FieldReader::count(std::size_t leastElement_bytes) {
  const std::size_t count = number<std::uint32_t>();
  if (count > (message_.size - position_) / leastElement_bytes) {
    throw BagDamage("sources.message_unreadable",
                    "claims a list of " + std::to_string(count) + " parts, for which it is too short");
  }
  return count;
}

ByteView FieldReader::take(std::size_t size) {
  if (size > message_.size - position_) {
    throw BagDamage("sources.message_unreadable", "ends at byte " + std::to_string(message_.size) + ", where " +
                                                      std::to_string(size) + " bytes from " +
                                                      std::to_string(position_) + " on should be");
  }
  const ByteView taken(message_.data + position_, size);
  position_ += size;
  return taken;
}

void FieldReader::align(std::size_t size) {
  const std::size_t beyond = (position_ - origin_) % size;
  if (beyond != 0) take(size - beyond);
}

}  // namespace wardslam::bags
