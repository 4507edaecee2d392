#include "camera_format.h"

namespace wardslam::sources {

const std::vector<CameraFormat>& cameraFormats() {
  static const std::vector<CameraFormat> kFormats = {
      {"ORB-SLAM", readOrbSlamCamera},     {"stella_vslam", readStellaCamera},
      {"ROS or OpenCV", readCameraMatrix}, {"ROS (sensor_msgs/CameraInfo)", readCameraInfo},
      {"Kalibr", readKalibrCamera},        {"Open3D", readOpen3dCamera},
      {"NICE-SLAM", readNiceSlamCamera},   {"numbers alone (ETH3D, ScanNet)", readNumberCamera},
  };
  return kFormats;
}

}  // namespace wardslam::sources
