#pragma once

#include "camera/camera_mount.h"
#include "scene/setting.h"

namespace wardslam::synth {

/// A ward of one room: five beds along two walls, an aisle between them in which a CameraPath finds its way, a nurse
/// who passes close by, a porter who brings a trolley and leaves it standing, a visitor. Without people the trolley
/// stands where they would have left it.
[[nodiscard]] Scene buildWard(const SceneOptions& options);

/// 20 s of it, driven through along a CameraPath.
[[nodiscard]] Setting wardSetting(const SceneOptions& options, const CameraMount& mount);

/// When the porter lets go of the trolley.
constexpr double kTrolleyLeft_s = 5.8;

}  // namespace wardslam::synth
