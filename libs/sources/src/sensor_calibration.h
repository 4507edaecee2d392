#pragma once

#include "wardslam/sources/sensor_configuration.h"

namespace wardslam::sources {

/// What a sensor configuration says that cannot end well, told before the driver starts: a calibration of another image
/// size than the mode that is asked for (as the example that MRPT brings has), depth that is not grabbed, drivers that
/// take colour alone. Throws core::InputError. `hasCamera`: a camera file replaces the calibration.
void requireUsableSensor(const SensorConfiguration& sensor, bool hasCamera);

}  // namespace wardslam::sources
