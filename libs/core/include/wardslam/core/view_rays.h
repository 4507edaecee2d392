#pragma once

#include <opencv2/core.hpp>

#include "wardslam/core/camera_model.h"

namespace wardslam::core {

/// For each raw pixel the point (x, y, 1) at depth one on its view ray, lens distortion removed: CV_32FC2 of (x, y).
[[nodiscard]] cv::Mat viewRays(const CameraModel& camera);

}  // namespace wardslam::core
