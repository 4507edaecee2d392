#include "compressed_depth.h"

#include <gmock/gmock.h>

#include "bag_writing.h"
#include "wardslam/bags/bag_damage.h"

namespace wardslam::bags {
namespace {

Bytes rvl(std::uint32_t width, std::uint32_t height, std::initializer_list<std::uint32_t> words) {
  test::BytesMaker packed;
  packed.number(width).number(height);
  for (const std::uint32_t word : words) packed.number(word);
  return packed.bytes();
}

// image_transport_plugins chooses a and b so that a value v stands for a / (v - b): 1 / z = (v - b) / a.
TEST(CompressedDepth, InverseDepthIsQuantised) {
  const cv::Mat inverse = (cv::Mat_<std::uint16_t>(1, 4) << 0, 101, 201, 1);
  const cv::Mat depth_m = depthOfInverse(inverse, 100.0F, 1.0F);
  EXPECT_EQ(depth_m.at<float>(0), 0.0F);  // nothing measured
  EXPECT_FLOAT_EQ(depth_m.at<float>(1), 1.0F);
  EXPECT_FLOAT_EQ(depth_m.at<float>(2), 0.5F);
  EXPECT_EQ(depth_m.at<float>(3), 0.0F);  // infinitely far
}

// Worked out by hand: one 0, three values 1, 6, 1 as differences 1, +5, -5, which are 2, 10, 9 as zigzag; 10 and 9 take
// two half bytes each, the lower three bits first: 0xA 0x1, 0x9 0x1. So half bytes 1 3 2 A 1 9 1, filled up by 0.
TEST(CompressedDepth, UnpacksRvl) {
  const cv::Mat image = decodeRvl(rvl(2, 2, {0x132A1910U}));
  ASSERT_EQ(image.size(), cv::Size(2, 2));
  ASSERT_EQ(image.type(), CV_16UC1);
  EXPECT_EQ(image.at<std::uint16_t>(0, 0), 0);
  EXPECT_EQ(image.at<std::uint16_t>(0, 1), 1);
  EXPECT_EQ(image.at<std::uint16_t>(1, 0), 6);
  EXPECT_EQ(image.at<std::uint16_t>(1, 1), 1);
}

TEST(CompressedDepth, RefusesRvlThatDoesNotFit) {
  EXPECT_THROW(decodeRvl(rvl(2, 1, {0x132A1910U})), BagDamage);     // more than two pixels
  EXPECT_THROW(decodeRvl(rvl(4, 4, {0x132A1910U})), BagDamage);     // less than sixteen
  EXPECT_THROW(decodeRvl(rvl(4, 4, {0U, 0U, 0U, 0U})), BagDamage);  // runs of nothing, for ever
  EXPECT_THROW(decodeRvl(rvl(4, 4, {0xFFFFFFFFU, 0xFFFFFFFFU})), BagDamage);
  EXPECT_THROW(decodeRvl(rvl(0x7FFFFFFFU, 0x7FFFFFFFU, {0U})), BagDamage);
  EXPECT_THROW(decodeRvl({}), BagDamage);
}

}  // namespace
}  // namespace wardslam::bags
