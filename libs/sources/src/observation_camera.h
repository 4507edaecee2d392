#pragma once

#include "wardslam/core/camera_model.h"

namespace mrpt::obs {
class CObservation3DRangeScan;
}

namespace wardslam::sources {

/// Replaces the calibration of the colour camera, and of the depth camera where the two coincide.
void replaceCamera(mrpt::obs::CObservation3DRangeScan& observation, const core::CameraModel& camera);

}  // namespace wardslam::sources
