#pragma once

#include <optional>
#include <vector>

#include "wardslam/core/options.h"
#include "wardslam/sources/rgbd_camera.h"

namespace wardslam::sources {

/// Calibrations as other programs write them: one reader each, in a file of its own. A reader returns nothing where the
/// file is not of its kind, and throws core::InputError where it is and cannot be used. What a file does not tell stays
/// 0: the image size (ORB-SLAM2), the unit of depth (all that describe a colour camera alone).
struct CameraFormat {
  const char* program;  ///< "ORB-SLAM", for sentences.
  std::optional<RgbdCamera> (*read)(const core::ConfigNode& root);
};

[[nodiscard]] std::optional<RgbdCamera> readOrbSlamCamera(const core::ConfigNode& root);
[[nodiscard]] std::optional<RgbdCamera> readStellaCamera(const core::ConfigNode& root);
[[nodiscard]] std::optional<RgbdCamera> readCameraMatrix(const core::ConfigNode& root);
[[nodiscard]] std::optional<RgbdCamera> readCameraInfo(const core::ConfigNode& root);
[[nodiscard]] std::optional<RgbdCamera> readKalibrCamera(const core::ConfigNode& root);
[[nodiscard]] std::optional<RgbdCamera> readOpen3dCamera(const core::ConfigNode& root);
[[nodiscard]] std::optional<RgbdCamera> readNiceSlamCamera(const core::ConfigNode& root);
[[nodiscard]] std::optional<RgbdCamera> readNumberCamera(const core::ConfigNode& root);

/// In the order in which they are tried.
[[nodiscard]] const std::vector<CameraFormat>& cameraFormats();

}  // namespace wardslam::sources
