#pragma once

#include <string>

namespace wardslam::sources {

/// Topics of a recording of ROS to read; where one is empty, it is found by type and name.
struct BagTopics {
  std::string color;
  std::string depth;
  std::string info;  ///< Calibration of the colour camera.
  std::string odometry;
};

}  // namespace wardslam::sources
