#include "field_reader.h"

#include <gmock/gmock.h>

namespace wardslam::bags {
namespace {

using ::testing::HasSubstr;

// DDS-XTYPES 1.3, 7.4.1: a byte, then a number of 4 bytes at offset 4, one of 8 at offset 8, each counted from behind
// the header; a text is its length with the zero, the letters and the zero.
const Bytes kLittle = {0, 1, 0, 0, 7, 0, 0, 0, 4, 3, 2, 1, 0, 0, 0, 0, 0, 0, 0xF8, 0x3F, 3, 0, 0, 0, 'a', 'b', 0};
const Bytes kBig = {0, 0, 0, 0, 7, 0, 0, 0, 1, 2, 3, 4, 0x3F, 0xF8, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 'a', 'b', 0};

void expectFields(const Bytes& message) {
  FieldReader fields(message, Wire::Cdr);
  EXPECT_EQ(fields.number<std::uint8_t>(), 7);
  EXPECT_EQ(fields.number<std::uint32_t>(), 0x01020304U);
  EXPECT_EQ(fields.number<double>(), 1.5);
  EXPECT_EQ(fields.text(), "ab");
}

TEST(FieldReader, AlignsCdrOfEitherByteOrder) {
  expectFields(kLittle);
  expectFields(kBig);
}

TEST(FieldReader, ReadsRos1WithoutGaps) {
  const Bytes message = {7, 4, 3, 2, 1, 0, 0, 0, 0, 0, 0, 0xF8, 0x3F, 2, 0, 0, 0, 'a', 'b'};
  FieldReader fields(message, Wire::Ros1);
  EXPECT_EQ(fields.number<std::uint8_t>(), 7);
  EXPECT_EQ(fields.number<std::uint32_t>(), 0x01020304U);
  EXPECT_EQ(fields.number<double>(), 1.5);
  EXPECT_EQ(fields.text(), "ab");
}

TEST(FieldReader, NeverReadsBeyondTheMessage) {
  for (std::size_t size = 0; size < kLittle.size(); ++size) {
    const Bytes cut(kLittle.begin(), kLittle.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THROW(
        {
          FieldReader fields(cut, Wire::Cdr);
          fields.number<std::uint8_t>();
          fields.number<std::uint32_t>();
          fields.number<double>();
          fields.text();
        },
        BagDamage)
        << size;
  }
}

TEST(FieldReader, BelievesNoCountThatTheMessageCannotHold) {
  const Bytes message = {0, 1, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF, 0, 0, 0, 0};
  FieldReader fields(message, Wire::Cdr);
  EXPECT_THROW(fields.count(8), BagDamage);
}

TEST(FieldReader, RefusesOtherSerialisations) {
  const Bytes parameterList = {0, 3, 0, 0, 1, 0, 0, 0};
  EXPECT_THROW(FieldReader(parameterList, Wire::Cdr), BagDamage);
  EXPECT_THROW(FieldReader(parameterList, Wire::Unknown), BagDamage);
}

}  // namespace
}  // namespace wardslam::bags
