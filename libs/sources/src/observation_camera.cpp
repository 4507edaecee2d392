#include "observation_camera.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include "wardslam/core/mrpt_compat.h"

namespace wardslam::sources {

void replaceCamera(mrpt::obs::CObservation3DRangeScan& observation, const core::CameraModel& camera) {
  observation.cameraParamsIntensity = core::toMrpt(camera);
  if (observation.doDepthAndIntensityCamerasCoincide()) observation.cameraParams = observation.cameraParamsIntensity;
}

}  // namespace wardslam::sources
