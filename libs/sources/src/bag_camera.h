#pragma once

#include <string>

#include "wardslam/bags/messages.h"
#include "wardslam/core/camera_model.h"

namespace wardslam::sources {

/// The camera of an image topic. `imageTopic`: where its name says that images are rectified ("image_rect_color"), they
/// have the projection matrix P and no distortion, else the matrix K. `where` begins sentences. Throws core::InputError
/// for a camera that is not calibrated, has a lens that plumb_bob does not describe, or shows a part of its image.
[[nodiscard]] core::CameraModel cameraOf(const bags::CameraInfo& info, const std::string& imageTopic,
                                         const std::string& where);

[[nodiscard]] bool isRectified(const std::string& imageTopic);

/// Whether what both say of pixels agrees to a pixel.
[[nodiscard]] bool areAlike(const core::CameraModel& a, const core::CameraModel& b);

}  // namespace wardslam::sources
