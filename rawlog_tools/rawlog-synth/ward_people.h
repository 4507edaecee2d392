#pragma once

#include <cstdint>

#include "scene.h"
#include "walker.h"

/// Who is in the ward, and their ways. Everybody repeats their round with the camera's period, so that nobody who
/// keeps clear of it once runs into it later.
namespace wardslam::synth {

[[nodiscard]] Walker porterWalk();
[[nodiscard]] Walker nurseWalk();
[[nodiscard]] Walker visitorWalk();

/// Adds nurse, porter and visitor as instances `firstId` and up.
void addPeople(Scene& scene, std::uint16_t firstId);

}  // namespace wardslam::synth
