#pragma once

#include <Eigen/Geometry>
#include <string>

#include "wardslam/bags/messages.h"

namespace wardslam::sources {

/// What RealSense's own recorder writes as text (std_msgs/String, "key=value;key=value") into recordings of ROS 2,
/// where it has messages of their own in bags of ROS 1. Each throws bags::BagDamage for a text that does not tell it.

/// "width=640;height=480;fx=600;ppx=320;fy=600;ppy=240;model=Brown Conrady;coeffs=0,0,0,0,0"
[[nodiscard]] bags::CameraInfo realSenseCamera(const std::string& text);

/// "rotation=1,0,0,0,1,0,0,0,1;translation=0.015,0,0", the matrix column by column.
[[nodiscard]] Eigen::Isometry3d realSensePlace(const std::string& text);

/// "0.001000", in metres.
[[nodiscard]] double realSenseNumber(const std::string& text);

}  // namespace wardslam::sources
