#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "wardslam/bags/bag_reader.h"
#include "wardslam/bags/byte_view.h"

/// The messages that are understood, as their definitions in ROS 1 and ROS 2 have them. Every function throws BagDamage
/// for a message that is shorter than it says.
namespace wardslam::bags {

struct Header {
  std::int64_t stamp_ns = 0;  ///< Since 1970, where the clock is that of the computer.
  std::string frame;          ///< Without the '/' that old recordings begin it with.
};

/// sensor_msgs/Image
struct Image {
  Header header;
  std::uint32_t height_px = 0;
  std::uint32_t width_px = 0;
  std::string encoding;
  bool isBigEndian = false;
  std::uint32_t step_bytes = 0;  ///< From row to row.
  ByteView data;                 ///< Lies in the message.
};

/// sensor_msgs/CompressedImage
struct CompressedImage {
  Header header;
  std::string format;  ///< "jpeg", "rgb8; jpeg compressed bgr8", "16UC1; compressedDepth png"
  ByteView data;       ///< Lies in the message.
};

/// sensor_msgs/CameraInfo
struct CameraInfo {
  Header header;
  std::uint32_t height_px = 0;
  std::uint32_t width_px = 0;
  std::string distortionModel;
  std::vector<double> d;
  std::array<double, 9> k{};   ///< Row by row; of the raw image.
  std::array<double, 12> p{};  ///< Row by row; of the rectified image.
  std::uint32_t binning_x = 0;
  std::uint32_t binning_y = 0;
  std::array<std::uint32_t, 4> roi_px{};  ///< x, y, height, width; all 0: the whole image.
};

/// geometry_msgs/TransformStamped: p_parent = T_parent_child * p_child, in metres.
struct Transform {
  Header header;  ///< Its frame is the parent.
  std::string child;
  Eigen::Isometry3d T_parent_child = Eigen::Isometry3d::Identity();
};

/// nav_msgs/Odometry
struct Odometry {
  Header header;
  std::string child;  ///< The frame of the robot.
  Eigen::Isometry3d T_odom_child = Eigen::Isometry3d::Identity();
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();  ///< In the frame of the robot.
  Eigen::Vector3d angularVelocity_radps = Eigen::Vector3d::Zero();
};

/// sensor_msgs/Imu; what its covariance says is not measured is not there.
struct Imu {
  Header header;
  std::optional<Eigen::Quaterniond> orientation;
  std::optional<Eigen::Vector3d> angularVelocity_radps;
  std::optional<Eigen::Vector3d> acceleration_mps2;
};

/// Of any message that begins with a std_msgs/Header; its first bytes do.
[[nodiscard]] Header readHeader(ByteView message, Wire wire);

[[nodiscard]] Image readImage(ByteView message, Wire wire);
[[nodiscard]] CompressedImage readCompressedImage(ByteView message, Wire wire);
[[nodiscard]] CameraInfo readCameraInfo(ByteView message, Wire wire);
[[nodiscard]] std::vector<Transform> readTransforms(ByteView message, Wire wire);  ///< tf2_msgs/TFMessage, tf/tfMessage
[[nodiscard]] Eigen::Isometry3d readTransform(ByteView message, Wire wire);        ///< geometry_msgs/Transform
[[nodiscard]] float readFloat32(ByteView message, Wire wire);                      ///< std_msgs/Float32
[[nodiscard]] std::string readText(ByteView message, Wire wire);                   ///< std_msgs/String
[[nodiscard]] Odometry readOdometry(ByteView message, Wire wire);
[[nodiscard]] Imu readImu(ByteView message, Wire wire);

}  // namespace wardslam::bags
