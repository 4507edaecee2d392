#pragma once

#include <optional>

#include "sensors/depth_sensor.h"
#include "sensors/exposure.h"
#include "sensors/kinect_noise.h"
#include "sensors/mishaps.h"
#include "sensors/motion_sensors.h"

namespace wardslam::synth {

/// How the camera's chips measure what the lens shows them, what goes wrong, and what else the robot measures.
struct SensorOptions {
  DepthSensor depth = DepthSensor::Kinect;
  KinectOptions kinect;  ///< Also: noise and vignetting of any camera's colours; scale of any sensor's depth noise.
  ExposureOptions exposure;
  MishapOptions mishaps;
  std::optional<OdometryOptions> odometry;
  std::optional<ImuOptions> imu;
};

}  // namespace wardslam::synth
