#include "wardslam/bags/messages.h"

#include <cmath>

#include "field_reader.h"

namespace wardslam::bags {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::size_t kCovariance = 36;
constexpr std::size_t kLeastTransform_bytes = 64;  // seven numbers of 8 bytes, time and two texts

Header headerOf(FieldReader& fields) {
  if (fields.wire() == Wire::Ros1) fields.number<std::uint32_t>();  // its number
  Header header;
  // Before 1970 in ROS 2, where the seconds have a sign; ROS 1 counts to the year 2106.
  const std::int64_t seconds = fields.wire() == Wire::Ros1 ? std::int64_t{fields.number<std::uint32_t>()}
                                                           : std::int64_t{fields.number<std::int32_t>()};
  header.stamp_ns = seconds * kSecond_ns + fields.number<std::uint32_t>();
  header.frame = fields.text();
  if (!header.frame.empty() && header.frame.front() == '/') header.frame.erase(0, 1);
  return header;
}

Eigen::Vector3d vectorOf(FieldReader& fields) {
  Eigen::Vector3d vector;
  for (int i = 0; i < 3; ++i) vector[i] = fields.number<double>();
  return vector;
}

Eigen::Quaterniond quaternionOf(FieldReader& fields) {
  Eigen::Quaterniond q;
  for (int i = 0; i < 4; ++i) q.coeffs()[i] = fields.number<double>();  // x y z w, as Eigen keeps them
  return q;
}

/// Position and orientation.
Eigen::Isometry3d poseOf(FieldReader& fields) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = vectorOf(fields);
  const Eigen::Quaterniond q = quaternionOf(fields);
  if (!T.translation().allFinite() || !(std::abs(q.norm() - 1.0) < 0.01)) {
    throw BagDamage("sources.message_unreadable",
                    "has a pose that is none: its quaternion has the length " + std::to_string(q.norm()));
  }
  T.linear() = q.normalized().toRotationMatrix();
  return T;
}

template <std::size_t Count>
std::array<double, Count> numbersOf(FieldReader& fields) {
  std::array<double, Count> numbers{};
  for (double& number : numbers) number = fields.number<double>();
  return numbers;
}

std::string withoutSlash(std::string frame) {
  if (!frame.empty() && frame.front() == '/') frame.erase(0, 1);
  return frame;
}

}  // namespace

Header readHeader(ByteView message, Wire wire) {
  FieldReader fields(message, wire);
  return headerOf(fields);
}

Image readImage(ByteView message, Wire wire) {
  FieldReader fields(message, wire);
  Image image;
  image.header = headerOf(fields);
  image.height_px = fields.number<std::uint32_t>();
  image.width_px = fields.number<std::uint32_t>();
  image.encoding = fields.text();
  image.isBigEndian = fields.number<std::uint8_t>() != 0;
  image.step_bytes = fields.number<std::uint32_t>();
  image.data = fields.bytes();
  return image;
}

CompressedImage readCompressedImage(ByteView message, Wire wire) {
  FieldReader fields(message, wire);
  CompressedImage image;
  image.header = headerOf(fields);
  image.format = fields.text();
  image.data = fields.bytes();
  return image;
}

CameraInfo readCameraInfo(ByteView message, Wire wire) {
  FieldReader fields(message, wire);
  CameraInfo info;
  info.header = headerOf(fields);
  info.height_px = fields.number<std::uint32_t>();
  info.width_px = fields.number<std::uint32_t>();
  info.distortionModel = fields.text();
  info.d.resize(fields.count(sizeof(double)));
  for (double& coefficient : info.d) coefficient = fields.number<double>();
  info.k = numbersOf<9>(fields);
  numbersOf<9>(fields);  // R
  info.p = numbersOf<12>(fields);
  info.binning_x = fields.number<std::uint32_t>();
  info.binning_y = fields.number<std::uint32_t>();
  for (std::uint32_t& edge : info.roi_px) edge = fields.number<std::uint32_t>();
  return info;
}

std::vector<Transform> readTransforms(ByteView message, Wire wire) {
  FieldReader fields(message, wire);
  std::vector<Transform> transforms(fields.count(kLeastTransform_bytes));
  for (Transform& transform : transforms) {
    transform.header = headerOf(fields);
    transform.child = withoutSlash(fields.text());
    transform.T_parent_child = poseOf(fields);
  }
  return transforms;
}

Eigen::Isometry3d readTransform(ByteView message, Wire wire) {
  FieldReader fields(message, wire);
  return poseOf(fields);
}

float readFloat32(ByteView message, Wire wire) {
  FieldReader fields(message, wire);
  return fields.number<float>();
}

std::string readText(ByteView message, Wire wire) {
  FieldReader fields(message, wire);
  return fields.text();
}

Odometry readOdometry(ByteView message, Wire wire) {
  FieldReader fields(message, wire);
  Odometry odometry;
  odometry.header = headerOf(fields);
  odometry.child = withoutSlash(fields.text());
  odometry.T_odom_child = poseOf(fields);
  numbersOf<kCovariance>(fields);
  odometry.velocity_mps = vectorOf(fields);
  odometry.angularVelocity_radps = vectorOf(fields);
  return odometry;
}

Imu readImu(ByteView message, Wire wire) {
  FieldReader fields(message, wire);
  Imu imu;
  imu.header = headerOf(fields);
  const Eigen::Quaterniond orientation = quaternionOf(fields);
  // The first number of a covariance is -1 where the element is not measured.
  if (numbersOf<9>(fields)[0] != -1.0 && std::abs(orientation.norm() - 1.0) < 0.01) imu.orientation = orientation;
  const Eigen::Vector3d angularVelocity = vectorOf(fields);
  if (numbersOf<9>(fields)[0] != -1.0) imu.angularVelocity_radps = angularVelocity;
  const Eigen::Vector3d acceleration = vectorOf(fields);
  if (numbersOf<9>(fields)[0] != -1.0) imu.acceleration_mps2 = acceleration;
  return imu;
}

}  // namespace wardslam::bags
