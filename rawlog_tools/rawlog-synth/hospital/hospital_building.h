#pragma once

#include "hospital/hospital_plan.h"
#include "scene/scene.h"

namespace wardslam::synth {

/// Floors, ceilings, walls with their rails, frames of doors: one thing a room, none of them an instance. Rooms of the
/// same size and kind are the same in their own frames.
[[nodiscard]] std::vector<Thing> buildWalls(const HospitalPlan& plan, std::uint32_t seed);

}  // namespace wardslam::synth
