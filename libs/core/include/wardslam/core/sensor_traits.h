#pragma once

#include "wardslam/core/depth_noise.h"

namespace wardslam::core {

/// What is known of a camera that MRPT's calibrations have no field for.
struct SensorTraits {
  DepthNoise depthNoise;   ///< A Kinect's where nothing is known.
  double readout_s = 0.0;  ///< From the first row to the last, negative where read from below; 0 = not known.
};

}  // namespace wardslam::core
