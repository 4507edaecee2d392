#include "wardslam/odometry/descriptor_words.h"

#include <gtest/gtest.h>

#include "wardslam/odometry/orb_descriptor.h"

namespace wardslam::odometry {
namespace {

TEST(DescriptorWords, DifferInAsManyBitsAsTheirBytes) {
  OrbDescriptor a{};
  OrbDescriptor b{};
  EXPECT_EQ(differingBits(wordsOf(a.data()), wordsOf(b.data())), 0);
  a[0] = 0x01;  // one bit,
  b[7] = 0xF0;  // four,
  a[31] = 0x80;
  b[31] = 0x81;  // one of these,
  a[16] = b[16] = 0xFF;
  EXPECT_EQ(differingBits(wordsOf(a.data()), wordsOf(b.data())), 6);
  EXPECT_EQ(differingBits(wordsOf(b.data()), wordsOf(a.data())), 6);
}

TEST(DescriptorWords, DifferInAllBits) {
  OrbDescriptor a{};
  OrbDescriptor b{};
  b.fill(0xFF);
  EXPECT_EQ(differingBits(wordsOf(a.data()), wordsOf(b.data())), 256);
  b[5] = 0x7F;
  EXPECT_EQ(differingBits(wordsOf(a.data()), wordsOf(b.data())), 255);
}

}  // namespace
}  // namespace wardslam::odometry
