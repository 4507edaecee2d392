#pragma once

#include <memory>

#include "wardslam/core/mrpt_compat.h"
#include "wardslam/mapping/semantic_map.h"

namespace wardslam::storage {

/// The map for MRPT's viewers: cloud, boxes with names around what stands there, zones and the way of the camera.
[[nodiscard]] std::shared_ptr<mrpt::opengl::COpenGLScene> makeScene(const mapping::SemanticMap& map);

}  // namespace wardslam::storage
