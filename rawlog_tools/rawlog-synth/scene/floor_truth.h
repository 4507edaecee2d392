#pragma once

#include "scene/scene.h"
#include "wardslam/mapping/floor_plan.h"

namespace wardslam::synth {

/// The true floor plan, world frame, cells of 2 cm: occupied where a surface lies in the way of a robot, from 5 cm to
/// 1.8 m over the floor. Of what moves at times only what has come to rest by `until_s` is in it.
[[nodiscard]] mapping::FloorPlan trueFloor(const Scene& scene, double until_s);
/// Of the storey whose floor is at that height.
[[nodiscard]] mapping::FloorPlan trueFloorAt(const Scene& scene, double until_s, float floorZ_m);

}  // namespace wardslam::synth
