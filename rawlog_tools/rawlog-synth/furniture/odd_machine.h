#pragma once

#include "scene/scene.h"

namespace wardslam::synth {

/// A machine on wheels that no network has a name for; pushed along x, handle at kOddMachineHandleX_m.
[[nodiscard]] Surfaces makeOddMachine(cv::RNG& rng);
constexpr double kOddMachineHandleX_m = -0.38;

}  // namespace wardslam::synth
