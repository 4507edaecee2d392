#pragma once

#include <functional>
#include <vector>

#include "hospital/hospital_items.h"
#include "hospital/hospital_plan.h"
#include "life/ways.h"

namespace wardslam::synth {

/// Along all corridors and through all rooms with an open door.
[[nodiscard]] WayGraph wayGraph(const HospitalPlan& plan);
/// One per chair.
[[nodiscard]] std::vector<Seat> seatsOf(const std::vector<Item>& items, const WayGraph& graph);
/// Beside the ways, clear of everything.
[[nodiscard]] std::vector<StandingSpot> standingSpots(const HospitalPlan& plan, const std::vector<Item>& items,
                                                      const WayGraph& graph);

}  // namespace wardslam::synth
