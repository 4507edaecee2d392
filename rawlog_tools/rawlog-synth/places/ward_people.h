#pragma once

#include "people/walker.h"

/// The ways of the people in the ward. Everybody repeats their round with the camera's period, so that nobody who
/// keeps clear of it once runs into it later.
namespace wardslam::synth {

[[nodiscard]] Walker porterWalk();
[[nodiscard]] Walker nurseWalk();
[[nodiscard]] Walker visitorWalk();

}  // namespace wardslam::synth
