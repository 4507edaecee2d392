#pragma once

#include <Eigen/Core>
#include <vector>

#include "hospital/hospital_plan.h"

namespace wardslam::synth {

/// Which rooms can be seen from a place, through doors that are not shut; more than can rather than less.
[[nodiscard]] std::vector<bool> roomsSeenFrom(const HospitalPlan& plan, const Eigen::Vector2d& p_m);

/// The room in which a door's leaf and frame are to be drawn: the one they are seen from whenever they are seen.
[[nodiscard]] std::size_t ownerOf(const Door& door);

}  // namespace wardslam::synth
