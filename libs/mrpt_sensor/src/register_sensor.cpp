#include <mrpt/core/initializer.h>

#include "semantic_rgbd_sensor.h"

MRPT_INITIALIZER(registerWardslamSensor) { wardslam::mrpt_sensor::CSemanticRGBDSensor::doRegister(); }
