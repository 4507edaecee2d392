#pragma once

#include <array>
#include <optional>

#include "wardslam/core/camera_model.h"

namespace wardslam::sources {

/// RealSense's "Inverse Brown Conrady" has a polynomial that leads from where a ray is seen to where it would be seen
/// without a lens; ours lead the other way. Sets k1, k2, p1, p2 and k3 of a camera, whose size and focal lengths are
/// known, to what comes nearest over the whole image (least squares). `inverse`: k1 k2 p1 p2 k3 as librealsense
/// orders them. The largest error of that (px); nothing, and the camera as it was, where there is no solution.
std::optional<double> setInverseLens(core::CameraModel& camera, const std::array<double, 5>& inverse);

}  // namespace wardslam::sources
