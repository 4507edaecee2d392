#pragma once

#include <filesystem>

#include "wardslam/sources/observation_source.h"
#include "wardslam/sources/rgbd_camera.h"

namespace wardslam::sources {

/// The camera of a folder of images, and where its numbers come from, to begin sentences with.
struct FolderCamera {
  RgbdCamera camera;
  std::filesystem::path file;
};

/// SourceOptions::camera, else the folder's camera.yaml, else TUM's own calibration where the folder is called
/// rgbd_dataset_freiburgN… or a comment in its lists says that it was made from such a recording; that is told. The
/// options' unit of depth replaces that of the file. Throws core::InputError where the camera is not known.
[[nodiscard]] FolderCamera chooseFolderCamera(const std::filesystem::path& folder, const SourceOptions& options);

}  // namespace wardslam::sources
