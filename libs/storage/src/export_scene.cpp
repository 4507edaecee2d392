#include <mrpt/opengl/COpenGLScene.h>

#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/storage/map_export.h"
#include "wardslam/storage/map_scene.h"

namespace wardslam::storage {

void exportScene(const mapping::SemanticMap& map, const std::filesystem::path& file) {
  const auto scene = makeScene(map);
  core::replaceAtomically(file, [&scene](const std::filesystem::path& partial) {
    if (!scene->saveToFile(partial.string())) throw core::InputError(partial.string() + ": cannot be written");
  });
}

}  // namespace wardslam::storage
