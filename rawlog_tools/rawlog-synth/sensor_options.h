#pragma once

#include "kinect_noise.h"

namespace wardslam::synth {

/// How the camera's chips measure what the lens shows them.
struct SensorOptions {
  KinectOptions kinect;
};

}  // namespace wardslam::synth
