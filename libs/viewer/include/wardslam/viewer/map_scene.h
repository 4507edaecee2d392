#pragma once

#include <filesystem>
#include <memory>

#include "wardslam/core/mrpt_compat.h"
#include "wardslam/mapping/semantic_map.h"

namespace wardslam::viewer {

/// The map for MRPT's viewers: cloud, boxes with names around what stands there, zones and the way of the camera.
[[nodiscard]] std::shared_ptr<mrpt::opengl::COpenGLScene> makeScene(const mapping::SemanticMap& map);

/// The same as a file for MRPT's SceneViewer3D (`.3Dscene`), complete or absent. Throws core::InputError when it cannot
/// be written.
void exportScene(const mapping::SemanticMap& map, const std::filesystem::path& file);

}  // namespace wardslam::viewer
