#pragma once

#include <cstdint>

#include "hospital/hospital_drives.h"
#include "hospital/hospital_route.h"

namespace wardslam::synth {

constexpr double kTourLength_m = 510.0;

/// The corners of a round, closed: from the last to the first.
[[nodiscard]] Polyline cornersOf(const HospitalPlan& plan, const RouteChoice& choice, std::uint32_t seed);

}  // namespace wardslam::synth
