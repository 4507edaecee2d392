#include "wardslam/bags/messages.h"

#include <gmock/gmock.h>

#include "bag_writing.h"

namespace wardslam::bags {
namespace {

test::BytesMaker ros1Header(const std::string& frame) {
  return test::BytesMaker()
      .number<std::uint32_t>(9)
      .number<std::uint32_t>(1700000000)
      .number<std::uint32_t>(500)
      .text(frame);
}

TEST(Messages, HeadersOfBothRosSayTheSame) {
  const Bytes ros1 = ros1Header("/camera").bytes();
  const Bytes ros2 = test::BytesMaker()
                         .raw(Bytes{0, 1, 0, 0})
                         .number<std::int32_t>(1700000000)
                         .number<std::uint32_t>(500)
                         .text(std::string("camera\0", 7))
                         .bytes();
  for (const Header& header : {readHeader(ros1, Wire::Ros1), readHeader(ros2, Wire::Cdr)}) {
    EXPECT_EQ(header.stamp_ns, 1700000000'000000500);
    EXPECT_EQ(header.frame, "camera");
  }
}

Bytes transformMessage(double w) {
  test::BytesMaker message;
  message.number<std::uint32_t>(1).raw(ros1Header("base_link").bytes()).text("/camera");
  for (const double number : {1.0, 2.0, 3.0, 0.0, 0.0, 0.6, w}) message.number(number);
  return message.bytes();
}

TEST(Messages, ReadsTransforms) {
  const auto transforms = readTransforms(transformMessage(0.8), Wire::Ros1);
  ASSERT_EQ(transforms.size(), 1U);
  EXPECT_EQ(transforms[0].header.frame, "base_link");
  EXPECT_EQ(transforms[0].child, "camera");
  EXPECT_EQ(transforms[0].T_parent_child.translation(), Eigen::Vector3d(1, 2, 3));
  // A turn by 2 atan2(0.6, 0.8) about z: x goes to (cos, sin) = (0.28, 0.96).
  EXPECT_TRUE(
      (transforms[0].T_parent_child.linear() * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d(0.28, 0.96, 0)));
}

TEST(Messages, RefusesAPoseThatIsNone) { EXPECT_THROW(readTransforms(transformMessage(0.1), Wire::Ros1), BagDamage); }

TEST(Messages, WhatAnImuDoesNotMeasureIsNotThere) {
  test::BytesMaker message = ros1Header("imu");
  const auto numbers = [&](std::initializer_list<double> values, int zeros) {
    for (const double value : values) message.number(value);
    for (int i = 0; i < zeros; ++i) message.number(0.0);
  };
  numbers({0, 0, 0, 1}, 0);
  numbers({-1}, 8);  // covariance of the orientation: there is none
  numbers({1, 2, 3}, 9);
  numbers({4, 5, 6}, 9);
  const Imu imu = readImu(message.bytes(), Wire::Ros1);
  EXPECT_FALSE(imu.orientation);
  EXPECT_EQ(imu.angularVelocity_radps.value(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(imu.acceleration_mps2.value(), Eigen::Vector3d(4, 5, 6));
}

TEST(Messages, MessagesThatEndEarlyAreRefused) {
  const Bytes header = ros1Header("imu").bytes();
  EXPECT_THROW(readImage(header, Wire::Ros1), BagDamage);
  EXPECT_THROW(readCompressedImage(header, Wire::Ros1), BagDamage);
  EXPECT_THROW(readCameraInfo(header, Wire::Ros1), BagDamage);
  EXPECT_THROW(readOdometry(header, Wire::Ros1), BagDamage);
  EXPECT_THROW(readImu(header, Wire::Ros1), BagDamage);
}

}  // namespace
}  // namespace wardslam::bags
